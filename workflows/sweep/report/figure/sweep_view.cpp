#include "workflows/sweep/report/figure/sweep_view.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "workflows/sweep/report/figure/key_axis.hpp"

namespace fpkcheck::sweep {
namespace {

// Returns the parameters that the sweep does not vary and that differ from their default values,
// e.g. "c = 0.1".
std::vector<std::string> fixed_parameter_list(const SweepPlan& plan) {
  std::vector<std::string> list;
  for (const auto& parameter : problem::parameters_for_reports(plan.base)) {
    const std::string key = parameter.section + '.' + parameter.name;
    if (parameter.is_default || std::ranges::count(plan.axes, key, &SweepAxis::key) > 0) continue;
    if (std::holds_alternative<bool>(parameter.value)) {
      list.emplace_back("no wall");
    } else if (parameter.typeset.empty()) {
      list.push_back(SweepParameterAxis::parameter_value_text(parameter.value) + " impulses");
    } else {
      list.push_back(fmt::format("{} = {}", parameter.typeset,
                                 SweepParameterAxis::parameter_value_text(parameter.value)));
    }
  }
  return list;
}

}  // namespace

SweepResultsView::SweepResultsView(const SweepResults& results)
    : results_(results), by_number_(results.plan.points.size(), nullptr) {
  for (const auto& point : results.points) by_number_[point.point] = &point;
}

const SweepMethodResult* SweepResultsView::method_result(std::size_t point_number,
                                                         std::size_t method_index) const {
  const SweepPointResult* found = point_result(point_number);
  return found == nullptr ? nullptr : &found->methods[method_index];
}

bool SweepResultsView::is_reference(std::size_t point_number, std::size_t method_index) const {
  const SweepPointResult* found = point_result(point_number);
  return found != nullptr && found->reference == sweep_plan().methods[method_index].id();
}

std::optional<MarginalL1Values> SweepResultsView::reference_error(std::size_t point_number) const {
  for (std::size_t method_index = 0; method_index < sweep_plan().methods.size(); ++method_index) {
    if (is_reference(point_number, method_index))
      return method_result(point_number, method_index)->error;
  }
  return std::nullopt;
}

std::optional<double> SweepResultsView::larger_marginal_l1(std::size_t point_number,
                                                           std::size_t method_index) const {
  const SweepMethodResult* found = method_result(point_number, method_index);
  if (found == nullptr || !found->l1 || is_reference(point_number, method_index))
    return std::nullopt;
  const double l1 = std::max(found->l1->y, found->l1->ydot);
  if (!std::isfinite(l1)) return std::nullopt;
  return l1;
}

bool SweepResultsView::has_distances() const {
  for (const auto& point : results_.points) {
    for (std::size_t method_index = 0; method_index < point.methods.size(); ++method_index) {
      if (larger_marginal_l1(point.point, method_index)) return true;
    }
  }
  return false;
}

std::string SweepResultsView::common_reference_id() const {
  std::string only;
  for (const auto& point : results_.points) {
    if (point.reference.empty()) continue;
    if (!only.empty() && only != point.reference) return "";
    only = point.reference;
  }
  return only;
}

std::vector<std::size_t> SweepResultsView::compared_method_indices() const {
  const std::string always_reference = common_reference_id();
  std::vector<std::size_t> compared;
  for (std::size_t method_index = 0; method_index < sweep_plan().methods.size(); ++method_index) {
    if (sweep_plan().methods[method_index].id() != always_reference)
      compared.push_back(method_index);
  }
  return compared;
}

std::vector<std::string> SweepResultsView::figure_title_parts() const {
  std::vector<std::string> parts{sweep_plan().base.name + ": "};
  for (const auto& parameter : fixed_parameter_list(sweep_plan())) {
    if (parts.size() > 1) parts.back() += ", ";
    parts.push_back(parameter);
  }
  return parts;
}

std::string fixed_parameters_text(const SweepPlan& plan) {
  return fmt::format("{}", fmt::join(fixed_parameter_list(plan), ", "));
}

}  // namespace fpkcheck::sweep
