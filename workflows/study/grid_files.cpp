#include <fmt/format.h>

#include "transform/metric.hpp"
#include "workflows/study/grid.hpp"

namespace fpkcheck::study {

using base::Value;
using transform::Moments;
using transform::ObservedConvergenceOrders;
using transform::value_from_count;

Record make_record(const GridRow& row) {
  Record record{
      {"order", value_from_count(row.order)}, {"level", value_from_count(row.level)},
      {"refinement", row.refinement},         {"nx", value_from_count(row.nx)},
      {"nv", value_from_count(row.nv)},       {"origin_refinement", row.origin_refinement}};
  add_outcome(row.solution, row.l1, record);
  record.push_back({"observed_order.l1", value(row.observed, &ObservedConvergenceOrders::l1)});
  record.push_back({"observed_order.y2", value(row.observed, &ObservedConvergenceOrders::y2)});
  record.push_back({"observed_order.v2", value(row.observed, &ObservedConvergenceOrders::v2)});
  record.push_back({"y2", row.density ? Value(row.density->moments.y2) : Value()});
  record.push_back({"v2", row.density ? Value(row.density->moments.v2) : Value()});
  return record;
}

Record make_record(const GridLimit& limit) {
  Record record{{"order", value_from_count(limit.order)},
                {"l1_y", value(limit.l1, &MarginalL1Distances::y)},
                {"l1_ydot", value(limit.l1, &MarginalL1Distances::ydot)}};
  for (const auto& [name, symbol, moment, size] : transform::kMoments) {
    if (moment == &Moments::v1) continue;  // E[y'] = 0 for every stationary density
    const bool known = limit.density.has_value();
    record.push_back({name, known ? Value(limit.density->moments.*moment) : Value()});
    record.push_back({fmt::format("{}_error", name), known ? Value(limit.error.*moment) : Value()});
  }
  return record;
}

Record make_record(const ComparedMethodRow& row) {
  const auto& identity = row.solution.identity;
  Record record{
      {"id", identity.id},
      {"method", identity.method},
      {"formulation", identity.formulation.empty() ? Value() : Value(identity.formulation)},
      {"order", identity.order ? value_from_count(*identity.order) : Value()}};
  add_outcome(row.solution, row.l1, record);
  const auto& sampling = row.solution.sampling;
  if (!sampling) {
    record.push_back({"sampling_l1", {}});
    return record;
  }
  record.push_back({"sampling_l1.y", transform::value_from_optional(sampling->y)});
  record.push_back({"sampling_l1.ydot", transform::value_from_optional(sampling->ydot)});
  record.push_back({"sampling_l1.y_99", transform::value_from_optional(sampling->y_99)});
  record.push_back({"sampling_l1.ydot_99", transform::value_from_optional(sampling->ydot_99)});
  return record;
}

std::string json(const GridStudy& study, const std::string& command) {
  const GridLimit& reference_limit = study.reference_limit();
  return study_json(
      GridStudy::kName, study.problem, command,
      {{"equation", std::string(problem::name(*study.grids.equation))},
       {"impact", std::string(problem::name(*study.grids.impact))},
       {"ratio", transform::kRefinementRatio},
       {"truth.order",
        reference_limit.failure.empty() ? value_from_count(reference_limit.order) : Value()},
       {"truth.reason", reference_limit.failure},
       {"truth.known_to.y", value(study.limit_accuracy, &MarginalL1Distances::y)},
       {"truth.known_to.ydot", value(study.limit_accuracy, &MarginalL1Distances::ydot)}},
      {{"limits", records(study.limits)},
       {"rows", records(study.rows)},
       {"others", records(study.others)}});
}

std::string csv(const GridStudy& study) {
  auto rows = records(study.rows);
  for (auto& row : rows) row.push_back({"id", study.grids.id});
  for (const auto& other : study.others) rows.push_back(make_record(other));
  return csv_text(
      rows, "id order level nx nv status l1_y l1_ydot observed_order=observed_order.l1 seconds");
}

}  // namespace fpkcheck::study
