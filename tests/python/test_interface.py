"""The hand-kept type hints (*.pyi) are those of the module, and everything public has a docstring."""

import ast
import inspect
import re
from pathlib import Path

import bitrock

FOLDER = Path(bitrock.__file__).parent
SOURCE = FOLDER.joinpath("__init__.py").resolve().parents[2]


def stub(name):
    return ast.parse((FOLDER / name).read_text())


def arguments(definition):
    """Names in order, those by keyword alone, and defaults by name."""
    a = definition.args
    defaults = dict(zip([x.arg for x in a.args][len(a.args) - len(a.defaults) :], a.defaults))
    defaults |= {x.arg: d for x, d in zip(a.kwonlyargs, a.kw_defaults) if d is not None}
    return (
        [x.arg for x in a.args],
        [x.arg for x in a.kwonlyargs],
        a.kwarg is not None,
        {name: ast.literal_eval(default) for name, default in defaults.items()},
    )


def signature(function):
    """Of a function of the C++ side: the first line of its docstring."""
    line = function.__doc__.splitlines()[0]
    line = re.sub(r"<[^>]*>", "None", line)
    return arguments(ast.parse(f"def {line}: ...").body[0])


def test_names_of_the_package():
    names = {n.name for n in stub("__init__.pyi").body if isinstance(n, (ast.FunctionDef, ast.ClassDef))}
    assert names | {"peaks", "__version__"} == set(bitrock.__all__)
    assert {n.name for n in stub("peaks.pyi").body if isinstance(n, ast.FunctionDef)} == set(bitrock.peaks.__all__)


def test_functions():
    found = 0
    for file, module in [("__init__.pyi", bitrock), ("peaks.pyi", bitrock.peaks)]:
        for node in stub(file).body:
            if isinstance(node, ast.FunctionDef):
                assert arguments(node) == signature(getattr(module, node.name)), node.name
                found += 1
    assert found >= 14


def test_classes():
    for node in stub("__init__.pyi").body:
        if not isinstance(node, ast.ClassDef):
            continue
        kind = getattr(bitrock, node.name)
        members = {n.name: n for n in node.body if isinstance(n, ast.FunctionDef)}
        if issubclass(kind, Exception) or issubclass(kind, Warning):
            continue
        there, told = ({n for n in names if not n.startswith("_")} for names in (vars(kind), members))
        assert there == told, node.name
        for name, member in members.items():
            value = inspect.getattr_static(kind, name)
            is_property = any(getattr(d, "id", "") == "property" for d in member.decorator_list)
            assert isinstance(value, property) == is_property, f"{node.name}.{name}"
            if not is_property and name != "__len__":
                assert arguments(member) == signature(getattr(kind, name)), f"{node.name}.{name}"


def test_docstrings():
    for name in bitrock.__all__:
        if name == "__version__":
            continue
        thing = getattr(bitrock, name)
        assert thing.__doc__ and len(thing.__doc__) > 20, name
        if inspect.isclass(thing) and not issubclass(thing, Exception):
            for member, value in vars(thing).items():
                assert member.startswith("_") or (value.__doc__ or "").strip(), f"{name}.{member}"


def test_version_is_that_of_the_build():
    assert f"project(bitrock VERSION {bitrock.__version__} " in (SOURCE / "CMakeLists.txt").read_text()

