#pragma once
/// The model as an ONNX graph, for whatever reads ONNX: units and scaling are inside, so that SI goes in and SI comes
/// out. It does not say whether conditions lie inside the training range, and it does not clamp to it: the range is in
/// the metadata.
///
/// **Equation** of column i of `statistics`, for a row c of `conditions`:
///   s_j = (c_j - offset_j u_j) / (scale_j u_j),  g = network(s),  t = offset + scale g,
///   statistic = max(0, t), or max(0, y_0 (e^t - 1)) with a log reference y_0.
/// **Symbols** c conditions (m/s, m, rad); u_j = `si_per_unit`; offset, scale, y_0 of `Variable` and `OutputModel`
/// [in the unit of the variable, or 1]; g what the network gives [1].
/// **Source** [ONNX]: operators Sub, Mul, Gemm, Relu, Softplus, Add, Exp, Concat of operator set 13, file version 7.
/// Constants of one dimension: readers of restricted broadcasting (OpenCV 4.6) take those for any number of rows.
/// **Differences and validity** Numbers are of 32 bits, as programs that run ONNX expect. The difference is written
/// s_j = (c_j - ..) * .. and not as one product and sum, because subtracting near values is exact and what follows then
/// adds no more than its own rounding. Inside the training range the answers of all kinds of network tested differ
/// from `predict` by less than 1e-5 (|statistic| + scale), where scale is y_0 with a log reference. Not-a-number in may
/// come out as 0 from some programs.

#include <string>

#include "surrogate/net/model.hpp"

namespace bitrock::surrogate {

/// The bytes of the file, checked by ONNX' own checker. The same model always gives the same bytes. Throws
/// `base::InputError` when a number of the model does not fit into 32 bits, or when bitrock was built without ONNX.
std::string onnx_file(const Model& model);

}  // namespace bitrock::surrogate
