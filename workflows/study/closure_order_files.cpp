#include "workflows/study/closure_order.hpp"

namespace fpkcheck::study {

using base::Value;

Record make_record(const ClosureOrderRow& row) {
  const auto& [identity, equation, impact] =
      std::tie(row.solution.identity, row.solution.identity.equation, row.solution.identity.impact);
  const auto number = [&](double of_density) {
    return row.solution.has_density() ? Value(of_density) : Value();
  };
  Record record{{"id", identity.id},
                {"formulation", row.formulation},
                {"order", transform::value_from_count(row.order)},
                {"equation", equation ? Value(std::string(name(*equation))) : Value()},
                {"impact", impact ? Value(std::string(name(*impact))) : Value()},
                {"mass", number(row.solution.mass)},
                {"min_density", number(row.solution.min_density)},
                {"energy_residual", number(row.solution.energy_residual)}};
  add_outcome(row.solution, row.l1, record);
  record.push_back({"tail_y", transform::value_from_optional(row.tail_y)});
  record.push_back({"tail_ydot", transform::value_from_optional(row.tail_ydot)});
  for (const auto& observation : row.solution.metrics) {
    if (observation.path == "formulation" || observation.path == "order") continue;  // added above
    record.push_back({observation.path, observation.value});
  }
  return record;
}

std::string json(const ClosureOrderStudy& study, const std::string& command) {
  const auto& reference = study.reference;
  return study_json(ClosureOrderStudy::kName, study.problem, command,
                    {{"reference.id", reference.id()},
                     {"reference.status", std::string(name(reference.status))},
                     {"reference.reason", reference.reason},
                     {"reference.seconds", reference.seconds}},
                    {{"rows", records(study.rows)}});
}

std::string csv(const ClosureOrderStudy& study) {
  return csv_text(
      records(study.rows),
      "formulation order status iterations residual condition l1_y l1_ydot tail_y tail_ydot seconds");
}

}  // namespace fpkcheck::study
