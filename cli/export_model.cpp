// bitrock export c, matlab, onnx: a trained model for programs that are not bitrock. SI in and out.
#include <memory>

#include "base/errors.hpp"
#include "base/files.hpp"
#include "cli/command.hpp"
#include "surrogate/export/c_source.hpp"
#include "surrogate/export/columns.hpp"
#include "surrogate/export/matlab_source.hpp"
#include "surrogate/export/onnx_file.hpp"
#include "surrogate/net/model_file.hpp"

namespace bitrock::cli {

namespace {

struct Options {
  CommonOptions common;
  std::string model_file, output, prefix;
};

template <class Columns>
nlohmann::json as_json(const Columns& columns) {
  nlohmann::json list = nlohmann::json::array();
  for (const surrogate::Column& column : columns)
    list.push_back({{"name", column.name}, {"unit", column.unit}, {"low", column.low}, {"high", column.high}});
  return list;
}

/// `bytes_of` makes the file from the model.
template <class BytesOf>
void export_model(const Options& options, const BytesOf& bytes_of) {
  const surrogate::Model model = surrogate::read_cut_model(options.model_file);
  require_outputs(options.common, {options.model_file}, {options.output});
  base::write_whole(options.output, bytes_of(model));
  say(options.common, "-> {}\n", options.output);
  write_json(options.common, {{"files", {options.output}},
                              {"rock", model.rock},
                              {"conditions", as_json(surrogate::condition_columns(model))},
                              {"statistics", as_json(surrogate::statistic_columns(model))}});
}

/// A function of MATLAB is called like its file.
std::string matlab_name(const std::string& output) {
  const std::filesystem::path path = output;
  if (path.extension() != ".m") throw base::InputError(fmt::format("{} (a MATLAB file must end in .m)", output));
  return path.stem().string();
}

std::shared_ptr<Options> add_format(CLI::App& command, const char* default_output) {
  auto options = std::make_shared<Options>();
  add_model_file(command, options->model_file);
  command.add_option("-o,--output", options->output, "The result goes to this file.")
      ->default_val(default_output)
      ->check(not_empty());
  add_common(command, options->common);
  return options;
}

}  // namespace

void add_export_model(CLI::App& export_command) {
  CLI::App* c = export_command.add_subcommand("c", "Writes a model as one file of C99 that needs nothing but libm.");
  const auto c_options = add_format(*c, "model.c");
  c->add_option("--prefix", c_options->prefix, "All names in the file begin with this: NAME_predict and so on.")
      ->default_val("bitrock");
  c->callback([c_options] {
    export_model(*c_options,
                 [&](const surrogate::Model& model) { return surrogate::c_source(model, c_options->prefix); });
  });

  CLI::App* matlab =
      export_command.add_subcommand("matlab", "Writes a model as a MATLAB function with the name of its file.");
  const auto matlab_options = add_format(*matlab, "bitrock_predict.m");
  matlab->callback([matlab_options] {
    export_model(*matlab_options, [&](const surrogate::Model& model) {
      return surrogate::matlab_source(model, matlab_name(matlab_options->output));
    });
  });

  CLI::App* onnx = export_command.add_subcommand(
      "onnx", "Writes a model as an ONNX graph with its scaling inside, in 32-bit numbers.");
  const auto onnx_options = add_format(*onnx, "model.onnx");
  onnx->callback([onnx_options] { export_model(*onnx_options, surrogate::onnx_file); });
}

}  // namespace bitrock::cli
