#pragma once

#include <optional>
#include <string>
#include <vector>

#include "workflows/sweep/result/sweep_results.hpp"

namespace fpkcheck::sweep {

/// Results of a sweep with the queries that the figures need. A SweepView keeps a reference to the
/// results.
class SweepView {
 public:
  explicit SweepView(const SweepResults& results);

  const SweepResults& results() const { return results_; }
  const Plan& plan() const { return results_.plan; }

  /// Returns the result of a point; a null pointer if the point was not solved.
  const PointResult* point_result(std::size_t number) const { return by_number_[number]; }
  const MethodResult* method_result(std::size_t number, std::size_t m) const;
  bool is_reference(std::size_t number, std::size_t m) const;
  /// Returns the error estimate of a point's reference; empty if the reference has no error
  /// estimate.
  std::optional<MarginalL1Pair> reference_error(std::size_t number) const;
  /// Returns the larger of the L1 distances of both marginal densities to the point's reference.
  std::optional<double> larger_l1(std::size_t number, std::size_t m) const;

  bool has_distances() const;
  /// Returns the id of the reference that all points share; "" if the references differ.
  std::string common_reference() const;
  /// Returns whether the method is the reference of every point that has a reference.
  bool is_always_reference(std::size_t m) const;
  /// Returns the indices of all methods except a method that is always the reference.
  std::vector<std::size_t> compared_methods() const;

  /// Returns the parts of a figure's title: the parameters that are not varied.
  std::vector<std::string> title() const;

 private:
  const SweepResults& results_;
  std::vector<const PointResult*> by_number_;
};

/// Returns the parameters with equal values at all points as a line of text, e.g. "c = 0.1, k = 1".
std::string fixed_parameters(const Plan& plan);

}  // namespace fpkcheck::sweep
