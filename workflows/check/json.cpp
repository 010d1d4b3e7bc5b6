#include "results/json.hpp"

#include <nlohmann/json.hpp>

#include "results/run_json.hpp"
#include "workflows/check/check.hpp"

namespace fpkcheck::check {
namespace {

using results::Json;

Json json_of(const Figure& figure) {
  return {{"case", figure.case_name},
          {"solution", figure.solution},
          {"figure", figure.name},
          {"kind", name(figure.kind)},
          {"baseline", results::value_json(figure.baseline)},
          {"now", results::value_json(figure.now)},
          {"change", figure.change},
          {"allowed", figure.allowed},
          {"unit", unit(figure.kind)}};
}

}  // namespace

std::string check_json(const Check& check, const std::string& command,
                       const std::string& baseline) {
  Json kinds = Json::array(), moved = Json::array();
  for (const auto& [kind, count, moved_count, largest] : by_kind(check)) {
    kinds.push_back({{"kind", name(kind)},
                     {"figures", count},
                     {"moved", moved_count},
                     {"largest_allowed", largest == nullptr ? Json() : json_of(*largest)}});
  }
  for (const auto& figure : check.moved()) moved.push_back(json_of(figure));
  return results::text_of(results::with_null_for_non_finite(
      {{"schema", results::kSummarySchema},
       {"program", results::program_json(results::this_program(command))},
       {"baseline", baseline},
       {"tolerance", check.tolerances.deterministic},
       {"standard_errors", check.tolerances.standard_errors},
       {"solutions", check.solutions},
       {"figures", check.figures.size()},
       {"agrees", check.agrees()},
       {"moved", moved},
       {"kinds", kinds},
       {"notes", check.notes}}));
}

}  // namespace fpkcheck::check
