// Built instead of onnx_file.cpp where the ONNX library is not there.
#include "base/errors.hpp"
#include "surrogate/export/onnx_file.hpp"

namespace bitrock::surrogate {

std::string onnx_file(const Model&) {
  throw base::InputError(
      "this bitrock was built without ONNX (install Debian's libonnx-dev and libprotobuf-dev, and build again)");
}

}  // namespace bitrock::surrogate
