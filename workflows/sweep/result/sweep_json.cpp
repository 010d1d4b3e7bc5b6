#include <nlohmann/json.hpp>

#include "results/json.hpp"
#include "workflows/sweep/plan/plan_json.hpp"
#include "workflows/sweep/result/point_json.hpp"
#include "workflows/sweep/result/sweep_results.hpp"

namespace fpkcheck::sweep {

std::string json(const SweepResults& results, const std::string& command) {
  using results::Json;
  constexpr int kSchema = 1;
  Json json{{"schema", kSchema},
            {"program", results::program_json(results::this_program(command))},
            {"plan", plan_json(results.plan)},
            {"points", Json::array()}};
  for (const auto& point : results.points) {
    Json one = point_json(point);
    one["at"] = Json::object();
    for (std::size_t a = 0; a < results.plan.axes.size(); ++a) {
      one["at"][results.plan.axes[a].key] =
          results::value_json(results.plan.points[point.point][a]);
    }
    json["points"].push_back(std::move(one));
  }
  return results::json_text(json);
}

}  // namespace fpkcheck::sweep
