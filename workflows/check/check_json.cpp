#include "results/json.hpp"

#include <nlohmann/json.hpp>

#include "results/run_json.hpp"
#include "workflows/check/check.hpp"

namespace fpkcheck::check {
namespace {

using results::Json;

Json json_of(const QuantityChange& quantity_change) {
  return {{"case", quantity_change.case_name},
          {"solution", quantity_change.solution},
          {"figure", quantity_change.name},
          {"kind", name(quantity_change.kind)},
          {"baseline", results::value_json(quantity_change.baseline)},
          {"now", results::value_json(quantity_change.now)},
          {"change", quantity_change.change},
          {"allowed", quantity_change.allowed},
          {"unit", unit(quantity_change.kind)}};
}

}  // namespace

std::string check_json(const CheckResult& check, const std::string& command,
                       const std::string& baseline) {
  Json kinds = Json::array(), moved = Json::array();
  for (const auto& [kind, count, moved_count, largest] : summarise_by_kind(check)) {
    kinds.push_back({{"kind", name(kind)},
                     {"figures", count},
                     {"moved", moved_count},
                     {"largest_allowed", largest == nullptr ? Json() : json_of(*largest)}});
  }
  for (const auto& quantity_change : check.changed_quantities())
    moved.push_back(json_of(quantity_change));
  return results::json_text(results::with_null_for_non_finite(
      {{"schema", results::kSummarySchema},
       {"program", results::program_json(results::this_program(command))},
       {"baseline", baseline},
       {"tolerance", check.tolerances.deterministic},
       {"standard_errors", check.tolerances.standard_errors},
       {"solutions", check.solutions},
       {"figures", check.changes.size()},
       {"agrees", check.agrees_with_baseline()},
       {"moved", moved},
       {"kinds", kinds},
       {"notes", check.notes}}));
}

}  // namespace fpkcheck::check
