#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/figure/frame.hpp"
#include "workflows/sweep/result/sweep_results.hpp"

namespace fpkcheck::sweep {

/// Queries of the figures to the results of a sweep. Keeps a reference to the results.
class SweepView {
 public:
  explicit SweepView(const SweepResults& results,
                     report::FigureWidth width = report::FigureWidth::screen);

  const SweepResults& results() const { return results_; }
  const Plan& plan() const { return results_.plan; }

  /// Result of a point; null where the point was not solved.
  const PointResult* point(std::size_t number) const { return by_number_[number]; }
  const MethodResult* method(std::size_t number, std::size_t m) const;
  bool is_reference(std::size_t number, std::size_t m) const;
  /// Error estimate of the point's reference; empty where it has none.
  std::optional<MarginalPair> reference_error(std::size_t number) const;
  /// L1 distance to the point's reference, the larger of both marginals.
  std::optional<double> larger_l1(std::size_t number, std::size_t m) const;

  /// True if any method has a distance to a reference.
  bool has_distances() const;
  /// The reference of all points, or "" where the points have several references.
  std::string common_reference() const;
  /// True if the method is the reference of every point that has a reference.
  bool is_always_reference(std::size_t m) const;
  /// Indices of the methods whose distances are drawn: all but the one that is always the
  /// reference.
  std::vector<std::size_t> compared_methods() const;

  /// Medium of the figures, and their width in pixels.
  report::FigureWidth medium() const { return medium_; }
  int width() const;
  /// The fixed parameters, for the top of a figure.
  report::FigureTitle title() const;

 private:
  const SweepResults& results_;
  report::FigureWidth medium_;
  std::vector<const PointResult*> by_number_;
};

/// Parameters that are the same at all points, in one line: "c = 0.1, k = 1".
std::string fixed_parameters(const Plan& plan);

}  // namespace fpkcheck::sweep
