"""The content of an input file, given as a dict, as the text that the readers take."""

import json
import math
import os


def text(table):
    """TOML text of a dict of tables, keys and lists of tables."""
    return "\n".join(_lines(table, "")) + "\n"


def _lines(table, name):
    inner = []
    for key, value in table.items():
        path = f"{name}.{_key(key)}" if name else _key(key)
        if isinstance(value, dict):
            inner += [f"[{path}]", *_lines(value, path)]
        elif _is_list_of_tables(value):
            for entry in value:
                inner += [f"[[{path}]]", *_lines(entry, path)]
        else:
            yield f"{_key(key)} = {_value(value)}"
    yield from inner


def _is_list_of_tables(value):
    return isinstance(value, (list, tuple)) and len(value) > 0 and all(isinstance(entry, dict) for entry in value)


def _key(key):
    plain = str(key).replace("_", "").replace("-", "")
    return str(key) if plain.isascii() and plain.isalnum() else json.dumps(str(key))


def _value(value):
    if hasattr(value, "tolist"):  # of numpy
        value = value.tolist()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, int):
        return str(value)
    if isinstance(value, float):
        return repr(value) if math.isfinite(value) else str(value)
    if isinstance(value, (str, os.PathLike)):
        return json.dumps(os.fspath(value), ensure_ascii=False)
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(_value(entry) for entry in value) + "]"
    raise TypeError(f"{value!r} (a file holds numbers, texts, true or false, lists and tables)")
