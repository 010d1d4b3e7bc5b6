#pragma once

#include <optional>
#include <string>
#include <vector>

#include "workflows/sweep/result/sweep_results.hpp"

namespace fpkcheck::sweep {

/// View of the results of a sweep with queries for figures. A SweepResultsView keeps a reference to
/// the results.
class SweepResultsView {
 public:
  explicit SweepResultsView(const SweepResults& results);

  const SweepResults& results() const { return results_; }
  const SweepPlan& sweep_plan() const { return results_.plan; }

  /// Returns the result of a sweep point, or a null pointer if the point was not solved.
  const SweepPointResult* point_result(std::size_t point_number) const {
    return by_number_[point_number];
  }
  const SweepMethodResult* method_result(std::size_t point_number, std::size_t method_index) const;
  bool is_reference(std::size_t point_number, std::size_t method_index) const;
  /// Returns the error estimate of the reference solution of a sweep point; empty if the reference
  /// has no error estimate.
  std::optional<MarginalL1Values> reference_error(std::size_t point_number) const;
  /// Returns the larger of the L1 distances of p(y) and p(y') from the reference solution of the
  /// sweep point.
  std::optional<double> larger_marginal_l1(std::size_t point_number,
                                           std::size_t method_index) const;

  bool has_distances() const;
  /// Returns the id of the reference solution that all sweep points share; "" if the references
  /// differ.
  std::string common_reference_id() const;
  /// Returns the indices of the methods that are compared with a reference solution, without a
  /// method that is the reference of every point.
  std::vector<std::size_t> compared_method_indices() const;

  /// Returns the parts of a figure title. Each part of a figure title states one parameter that has
  /// the same value at all sweep points.
  std::vector<std::string> figure_title_parts() const;

 private:
  const SweepResults& results_;
  std::vector<const SweepPointResult*> by_number_;
};

/// Returns the parameters with equal values at all sweep points as a line of text, e.g. "c = 0.1, k
/// = 1".
std::string fixed_parameters_text(const SweepPlan& plan);

}  // namespace fpkcheck::sweep
