#include <nlohmann/json.hpp>

#include "results/json.hpp"
#include "results/run.hpp"
#include "workflows/sweep/report/advice_text.hpp"

namespace fpkcheck::sweep {
namespace {

results::Json nearby_json(const MethodNearby& one, const AdviceSetting& setting) {
  results::Json json{{"id", one.id},           {"promised", one.promised},
                     {"points", one.points},   {"ok", one.ok},
                     {"worst_l1", nullptr},    {"misstated", one.misstated},
                     {"seconds", one.seconds}, {"command", setting.command(one.id)}};
  if (one.worst_l1) json["worst_l1"] = *one.worst_l1;
  return json;
}

}  // namespace

std::string advice_json(const Advice& advice, const AdviceSetting& setting,
                        const std::string& command_line) {
  using results::Json;
  constexpr int kSchema = 1;
  const Place& place = advice.place;
  Json json{{"schema", kSchema},
            {"program", results::program_json(results::this_program(command_line))},
            {"case", setting.name},
            {"place",
             {{"impulses_per_decay_time", place.groups.impulses_per_decay_time},
              {"damping_ratio", place.groups.damping_ratio},
              {"cubic_share", place.groups.cubic_share},
              {"restitution", place.restitution},
              {"law", place.law},
              {"mean_share", place.mean_share}}},
            {"accuracy", advice.accuracy},
            {"outside", advice.outside()},
            {"nearest", advice.nearest},
            {"points_near", advice.near},
            {"recommended", nullptr},
            {"methods", Json::array()}};
  const auto promised = advice.promised();
  if (!promised.empty()) json["recommended"] = promised.front().id;
  if (promised.empty()) json["otherwise"] = setting.otherwise;
  for (const auto& one : advice.methods) json["methods"].push_back(nearby_json(one, setting));
  return results::text_of(json);
}

}  // namespace fpkcheck::sweep
