// For the scripts in this folder.
//   reference write MODEL.json      the model of mixed_model.hpp
//   reference predict MODEL.json    reads speed [m/s], depth [m] and rake [rad] a line, prints what `predict` answers
#include <cstdio>
#include <string_view>

#include "surrogate/net/model_file.hpp"
#include "tests/export/mixed_model.hpp"

using namespace bitrock;

int main(int count, char** arguments) {
  const std::string_view what = count == 3 ? arguments[1] : "";
  if (what == "write") {
    surrogate::write_model(arguments[2], mixed::model());
    return 0;
  }
  if (what != "predict") return 2;
  const surrogate::Model model = surrogate::read_model(arguments[2]);
  surrogate::CutConditions asked;
  while (std::scanf("%lf %lf %lf", &asked.cutter_speed, &asked.depth_of_cut, &asked.back_rake) == 3) {
    for (const double statistic : surrogate::listed(surrogate::predict(model, asked))) std::printf("%.17g ", statistic);
    std::printf("\n");
  }
  return 0;
}
