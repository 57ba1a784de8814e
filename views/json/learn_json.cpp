#include "views/json/learn_json.hpp"

#include "surrogate/net/model.hpp"

namespace bitrock::views {

nlohmann::json as_json(const studies::Learnt& learnt) {
  const studies::Knowledge& knowledge = learnt.last.knowledge;
  nlohmann::json outputs = nlohmann::json::object();
  for (std::size_t o = 0; o < knowledge.errors.size(); ++o)
    outputs[std::string(surrogate::output_names[o].name)] = {{"error", knowledge.errors[o]},
                                                             {"error_by_noise", knowledge.scatter[o]}};
  return {{"end", learnt.end == studies::LearnEnd::error_reached ? "error reached" : "time over"},
          {"batches", learnt.last.batch},
          {"cuts", knowledge.cuts},
          {"terms", knowledge.terms},
          {"wall_s", learnt.last.elapsed},
          {"core_s", learnt.core_time},
          {"force_error", knowledge.force_error},
          {"outputs", outputs}};
}

}  // namespace bitrock::views
