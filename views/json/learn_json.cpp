#include "views/json/learn_json.hpp"

#include "surrogate/net/model.hpp"

namespace bitrock::views {

nlohmann::json as_json(const studies::Learnt& learnt) {
  const studies::Knowledge& knowledge = learnt.last.knowledge;
  nlohmann::json outputs = nlohmann::json::object();
  for (std::size_t o = 0; o < knowledge.errors.size(); ++o)
    outputs[std::string(surrogate::output_names[o].name)] = {{"standard_error", knowledge.errors[o]}};
  return {{"end", learnt.end == studies::LearnEnd::error_reached ? "error reached" : "time over"},
          {"batches", learnt.last.batch},
          {"cuts", knowledge.cuts},
          {"terms", knowledge.terms},
          {"elapsed_s", learnt.last.elapsed},
          {"force_error", knowledge.force_error},
          {"outputs", outputs}};
}

}  // namespace bitrock::views
