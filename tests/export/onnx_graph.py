"""What `bitrock export onnx` writes, seen by others: ONNX' own checker and shape inference, the metadata, and answers
beside those of `bitrock predict`, computed by the few lines of numpy below or by OpenCV's DNN module.
  onnx_graph.sh {numpy|opencv} PROGRAM REFERENCE [MODEL.json]
REFERENCE is the program of reference.cpp, and the model its own unless one is named.
Needs Debian's python3-onnx, and python3-opencv for the second; ends with status 77 (skipped) without them, or when the
program was built without ONNX."""
import json
import math
import subprocess
import sys
import tempfile
from pathlib import Path


def skip(why):
    print("skipped:", why)
    sys.exit(77)


try:
    import numpy
    import onnx
    from onnx import numpy_helper, shape_inference
except ImportError as error:
    skip(f"{error} (package python3-onnx)")

CONDITIONS = 200
STATISTICS = ("amax", "amean", "np1", "np23", "np4")
# 32-bit numbers carry 6e-8; a network of five layers of up to 64 nodes adds up some tens of such roundings.
ALLOWED = 1e-5


def numpy_answers(path, conditions):
    """Each operator as the ONNX specification words it, in 32 bits."""
    graph = onnx.load(path).graph
    values = {constant.name: numpy_helper.to_array(constant) for constant in graph.initializer}
    values["conditions"] = conditions
    for node in graph.node:
        given = [values[name] for name in node.input]
        options = {option.name: option.i for option in node.attribute}
        if node.op_type == "Gemm":
            assert options == {"transB": 1}, options
            result = given[0] @ given[1].T + given[2]
        elif node.op_type == "Concat":
            result = numpy.concatenate(given, axis=options["axis"])
        else:
            result = {"Sub": lambda a, b: a - b, "Add": lambda a, b: a + b, "Mul": lambda a, b: a * b, "Exp": numpy.exp,
                      "Relu": lambda a: numpy.maximum(a, 0), "Softplus": lambda a: numpy.logaddexp(a, numpy.float32(0)),
                      }[node.op_type](*given)
        assert result.dtype == numpy.float32, (node.name, result.dtype)
        values[node.output[0]] = result
    return values["statistics"]


def opencv_answers(path, conditions):
    try:
        import cv2
    except ImportError as error:
        skip(f"{error} (package python3-opencv)")
    answers = {}
    for rows in (1, 2, 3, len(conditions)):
        network = cv2.dnn.readNetFromONNX(str(path))
        network.setInput(conditions[:rows])
        answers[rows] = network.forward()
        assert answers[rows].shape == (rows, 10), answers[rows].shape
    for rows in (1, 2, 3):  # a row does not depend on how many there are, but for the order of sums
        numpy.testing.assert_allclose(answers[rows], answers[len(conditions)][:rows], rtol=ALLOWED, atol=1e-3)
    return answers[len(conditions)]


def predicted(program, reference, model_file, conditions, scratch):
    """What `predict` answers; the program is asked, in its own units, for the first few."""
    lines = "".join(f"{speed!r} {depth!r} {rake!r}\n" for speed, depth, rake in conditions.tolist())
    printed = subprocess.run([reference, "predict", model_file], input=lines, capture_output=True, text=True,
                             check=True)
    answers = numpy.array([line.split() for line in printed.stdout.splitlines()], dtype=float)
    for row, answer in zip(conditions[:5].tolist(), answers):
        subprocess.run([program, "predict", model_file, "--speed-m-per-s", repr(row[0]),
                        "--depth-mm", repr(row[1] * 1e3), "--rake-deg", repr(math.degrees(row[2])),
                        "--quiet", "--json", scratch / "said.json"], check=True)
        said = json.loads((scratch / "said.json").read_text())
        assert said["inside_training_range"]
        # the way to mm and degrees and back rounds twice: some 1e-16 of a condition, more of an answer near its cut-off
        numpy.testing.assert_allclose([said[axis][name] for axis in "xy" for name in STATISTICS], answer,
                                      rtol=1e-11, atol=1e-6)
    return answers


def check_metadata(graph_file, model):
    """Names, units, ranges in SI and where the model came from."""
    metadata = {entry.key: entry.value for entry in graph_file.metadata_props}
    assert metadata["conditions_names"] == "cutter_speed_m_per_s,depth_of_cut_m,back_rake_rad", metadata
    assert metadata["conditions_units"] == "m/s,m,rad", metadata
    assert metadata["statistics_names"] == ",".join(output["name"] for output in model["outputs"]), metadata
    assert metadata["statistics_units"] == ",".join(output["unit"] for output in model["outputs"]), metadata
    to_si = numpy.array([1.0, 1e-3, math.pi / 180])
    for bound in ("low", "high"):
        found = numpy.array(metadata[f"conditions_{bound}"].split(","), dtype=float)
        numpy.testing.assert_allclose(found, to_si * [column[bound] for column in model["inputs"]], rtol=1e-15)
        found = numpy.array(metadata[f"statistics_{bound}"].split(","), dtype=float)
        numpy.testing.assert_array_equal(found, [column[bound] for column in model["outputs"]])
    assert metadata["rock"] == model["rock"], metadata
    assert metadata["data_fingerprint"] == model["provenance"]["data_fingerprint"], metadata
    assert graph_file.producer_name == "bitrock" and graph_file.producer_version
    return numpy.array([metadata["conditions_low"].split(","), metadata["conditions_high"].split(",")], dtype=float)


def main():
    how, program, reference = sys.argv[1:4]
    own_model = len(sys.argv) == 4
    answers_of = {"numpy": numpy_answers, "opencv": opencv_answers}[how]
    with tempfile.TemporaryDirectory() as folder:
        scratch = Path(folder)
        model_file = scratch / "model.json" if own_model else Path(sys.argv[4])
        if own_model:
            subprocess.run([reference, "write", model_file], check=True)
        graph_path = scratch / "model.onnx"
        export = subprocess.run([program, "export", "onnx", model_file, "-o", graph_path, "--quiet"],
                                stderr=subprocess.PIPE, text=True)
        if "built without ONNX" in export.stderr:
            assert export.returncode == 2, export.returncode
            skip("bitrock was built without ONNX")
        assert export.returncode == 0, export.stderr

        graph_file = onnx.load(graph_path)
        onnx.checker.check_model(graph_file, full_check=True)
        shape_inference.infer_shapes(graph_file, check_type=True, strict_mode=True)
        model = json.loads(model_file.read_text())
        low, high = check_metadata(graph_file, model)

        # The conditions as the graph sees them are those that `predict` is asked for; bounds are drawn a hair inside.
        drawn = numpy.random.default_rng(1).uniform(low, high, size=(CONDITIONS, 3)).astype(numpy.float32)
        answers = answers_of(graph_path, drawn)
        expected = predicted(program, reference, model_file, drawn.astype(float), scratch)
        scales = numpy.array([output["log_reference"] or output["scale"] for output in model["outputs"]])
        difference = numpy.abs(answers - expected)
        worst = (difference / (numpy.abs(expected) + scales)).max(axis=0)
        positive = numpy.mean(expected > 0, axis=0)
        for column, output in enumerate(model["outputs"]):
            large = expected[:, column] > 0.01 * scales[column]
            relative = (difference[large, column] / expected[large, column]).max(initial=0)
            print(f"{how:6} {output['name']:16} {output['output_activation']:9}"
                  f" log_reference {output['log_reference']:8.5g}  difference/(value + scale) {worst[column]:.1e}"
                  "  difference/value above a hundredth of the scale"
                  f" {relative:.1e}  above zero {positive[column]:.2f}")
        assert (worst < ALLOWED).all(), worst
        assert not own_model or (positive > 0.3).all(), "the model answers zero too often to say anything"


main()
