#include "workflows/sweep/report/recommendation_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "report/text/text_layout.hpp"
#include "results/json_conversions.hpp"
#include "results/run.hpp"

namespace fpkcheck::sweep {
namespace {

using report::TextTableColumn;

constexpr std::size_t kShownMethods = 3;
constexpr double kLargeError = 0.05;

std::string coordinates_sentence(const MethodRecommendation& advice, const std::string& name) {
  const ValidityMapCoordinates& coordinates = advice.coordinates;
  std::string text = fmt::format(
      "{}: {:.2g} impulses per decay time, damping ratio {:.2g}, {:.0f} % of the stiffness cubic, "
      "r = {:.4g}, {} impulses",
      name, coordinates.groups.impulses_per_decay_time, coordinates.groups.damping_ratio,
      100 * coordinates.groups.cubic_share, coordinates.restitution, coordinates.law);
  if (coordinates.relative_mean != 0)
    text += fmt::format(", mean {:.2g} times the root mean square", coordinates.relative_mean);
  return text + '.';
}

std::string nearest_point_sentence(const MethodRecommendation& advice) {
  if (std::isinf(advice.nearest_distance)) {
    return advice.coordinates.relative_mean != 0
               ? "Outside the map: none of its points has impulses with a mean."
               : fmt::format("Outside the map: none of its points has {} impulses.",
                             advice.coordinates.law);
  }
  if (advice.is_outside_map()) {
    return fmt::format("Outside the map: the nearest point has distance {:.2g} (limit 1).",
                       advice.nearest_distance);
  }
  return fmt::format("Nearest point of the map: distance {:.2g}; {} points within 1.",
                     advice.nearest_distance, advice.nearby_points);
}

std::string nearby_results_table(const std::vector<MethodResultsAtNearbyPoints>& methods,
                                 const report::TerminalTextFormat& format) {
  constexpr const char* kNearby = "at the points nearby";
  std::vector<TextTableColumn> columns{{"", "method", true, report::kAlwaysShown},
                                       {kNearby, "points", false, 1},
                                       {kNearby, "ok", false, 2},
                                       {kNearby, "worst L1", false, report::kAlwaysShown},
                                       {kNearby, "seconds", false, 3}};
  for (const auto& one : methods) {
    report::add_table_row(
        columns, {one.id, std::to_string(one.points), std::to_string(one.ok),
                  one.worst_l1 ? fmt::format("{:.2g}", *one.worst_l1) : report::kMissingCell,
                  fmt::format("{:.2g}", one.seconds)});
  }
  return report::format_text_table(std::move(columns), format);
}

// Returns a sentence on the methods that underestimate their errors. The sentence on a method
// states its equation and impact condition, to which the status `ok` refers, e.g. "fd-white (solves
// white/map, error up to 0.11 at 31 of 31 points)".
std::string underestimated_error_sentence(const MethodRecommendation& advice,
                                          const methods::SolverRegistry& registry) {
  std::vector<std::string> items;
  for (const auto& one : advice.methods) {
    if (one.underestimated == 0) continue;
    const auto method = registry.find_method_by_id(one.id);
    items.push_back(
        fmt::format("{} ({}error up to {:.2g} at {} of {} points)", one.id,
                    method ? "solves " + equation_and_impact_text(method->identity) + ", " : "",
                    one.worst_l1.value_or(0), one.underestimated, one.points));
  }
  if (items.empty()) return {};
  return fmt::format("Status ok there, but error above twice the stated error: {}.",
                     fmt::join(items, "; "));
}

std::string large_error_sentence(const MethodRecommendation& advice) {
  std::vector<std::string> items;
  for (const auto& one : advice.methods) {
    if (one.underestimated > 0 || one.worst_l1.value_or(0) <= kLargeError) continue;
    items.push_back(fmt::format("{} ({:.2g})", one.id, *one.worst_l1));
  }
  if (items.empty()) return {};
  return fmt::format("Error above {:g} % at some of these points, as stated: {}.",
                     100 * kLargeError, fmt::join(items, ", "));
}

std::string missing_density_sentence(const MethodRecommendation& advice) {
  std::vector<std::string> items;
  for (const auto& one : advice.methods) {
    if (!one.worst_l1) items.push_back(one.id);
  }
  if (items.empty()) return {};
  return fmt::format("No probability density at any of these points: {}.", fmt::join(items, ", "));
}

results::Json nearby_results_json(const MethodResultsAtNearbyPoints& one,
                                  const RecommendationContext& context) {
  results::Json json{{"id", one.id},           {"promised", one.promised},
                     {"points", one.points},   {"ok", one.ok},
                     {"worst_l1", nullptr},    {"misstated", one.underestimated},
                     {"seconds", one.seconds}, {"command", context.command(one.id)}};
  if (one.worst_l1) json["worst_l1"] = *one.worst_l1;
  return json;
}

}  // namespace

std::string recommendation_text(const MethodRecommendation& advice,
                                const RecommendationContext& context,
                                const report::TerminalTextFormat& format) {
  const auto paragraph = [&](const std::string& text) {
    return text.empty() ? text : report::wrap_text(text, format.width);
  };
  std::string text =
      paragraph(coordinates_sentence(advice, context.name) + ' ' + nearest_point_sentence(advice));
  auto promised = advice.sufficiently_accurate_methods();
  if (promised.empty()) {
    text += '\n' + paragraph(fmt::format(
                       "No method met L1 {:g} at all nearby points. These methods estimate "
                       "their own errors:",
                       advice.accuracy));
    for (const auto& command : context.fallback_commands) text += "  " + command + '\n';
  } else {
    text += fmt::format(
        "\nRecommended for L1 {:g} of p(y) and p(y'), met at all nearby points:\n"
        "  {}\n",
        advice.accuracy, context.command(promised.front().id));
    promised.resize(std::min(promised.size(), kShownMethods));
    text += '\n' + nearby_results_table(promised, format);
    for (std::size_t k = 1; k < promised.size(); ++k) {
      text += (k == 1 ? "\nOr:\n  " : "  ") + context.command(promised[k].id) + '\n';
    }
  }
  const std::string status_note =
      "Status and stated error of a solution refer to this problem itself.";
  if (advice.is_outside_map()) return text + '\n' + paragraph(status_note);
  const std::string warnings = paragraph(underestimated_error_sentence(advice, context.registry)) +
                               paragraph(large_error_sentence(advice)) +
                               paragraph(missing_density_sentence(advice));
  if (!warnings.empty()) text += '\n' + warnings;
  return text + '\n' +
         paragraph("No guarantee: the map has no data between its points (docs/validity.md). " +
                   status_note);
}

std::string recommendation_json(const MethodRecommendation& advice,
                                const RecommendationContext& context,
                                const std::string& command_line) {
  using results::Json;
  constexpr int kSchema = 1;
  const ValidityMapCoordinates& coordinates = advice.coordinates;
  Json json{{"schema", kSchema},
            {"program", results::program_to_json(results::current_program(command_line))},
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
  const auto promised = advice.sufficiently_accurate_methods();
  if (!promised.empty()) json["recommended"] = promised.front().id;
  if (promised.empty()) json["otherwise"] = context.fallback_commands;
  for (const auto& one : advice.methods)
    json["methods"].push_back(nearby_results_json(one, context));
  return results::serialise_json(json);
}

}  // namespace fpkcheck::sweep
