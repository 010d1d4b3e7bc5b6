#include <nlohmann/json.hpp>

#include "results/json.hpp"
#include "results/run.hpp"
#include "workflows/sweep/report/advice_text.hpp"

namespace fpkcheck::sweep {
namespace {

results::Json nearby_json(const NearbyMethodResults& one, const AdviceContext& context) {
  results::Json json{{"id", one.id},           {"promised", one.promised},
                     {"points", one.points},   {"ok", one.ok},
                     {"worst_l1", nullptr},    {"misstated", one.underestimated},
                     {"seconds", one.seconds}, {"command", context.command(one.id)}};
  if (one.worst_l1) json["worst_l1"] = *one.worst_l1;
  return json;
}

}  // namespace

std::string advice_json(const Advice& advice, const AdviceContext& context,
                        const std::string& command_line) {
  using results::Json;
  constexpr int kSchema = 1;
  const MapCoordinates& coordinates = advice.coordinates;
  Json json{{"schema", kSchema},
            {"program", results::program_json(results::this_program(command_line))},
            {"case", context.name},
            {"place",
             {{"impulses_per_decay_time", coordinates.groups.impulses_per_decay_time},
              {"damping_ratio", coordinates.groups.damping_ratio},
              {"cubic_share", coordinates.groups.cubic_share},
              {"restitution", coordinates.restitution},
              {"law", coordinates.law},
              {"mean_share", coordinates.relative_mean}}},
            {"accuracy", advice.accuracy},
            {"outside", advice.is_outside_map()},
            {"nearest", advice.nearest_distance},
            {"points_near", advice.nearby_points},
            {"recommended", nullptr},
            {"methods", Json::array()}};
  const auto promised = advice.promised_methods();
  if (!promised.empty()) json["recommended"] = promised.front().id;
  if (promised.empty()) json["otherwise"] = context.fallback_commands;
  for (const auto& one : advice.methods) json["methods"].push_back(nearby_json(one, context));
  return results::json_text(json);
}

}  // namespace fpkcheck::sweep
