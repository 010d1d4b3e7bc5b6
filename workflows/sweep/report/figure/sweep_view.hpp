#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/figure/frame.hpp"
#include "workflows/sweep/result/sweep_results.hpp"

namespace fpkcheck::sweep {

/// What pictures ask of the results of a sweep. Refers to them.
class SweepView {
 public:
  explicit SweepView(const SweepResults& results,
                     report::FigureWidth width = report::FigureWidth::screen);

  const SweepResults& results() const { return results_; }
  const Plan& plan() const { return results_.plan; }

  /// Null where the point was not solved.
  const PointResult* point(std::size_t number) const { return by_number_[number]; }
  const MethodResult* method(std::size_t number, std::size_t m) const;
  bool is_reference(std::size_t number, std::size_t m) const;
  /// What the point's reference states of its own error; nothing where it states none.
  std::optional<MarginalPair> error_of_reference(std::size_t number) const;
  /// Distance to the point's reference, the larger of both marginals.
  std::optional<double> larger_l1(std::size_t number, std::size_t m) const;

  /// Whether anything was compared with a reference.
  bool has_distances() const;
  /// The reference of all points, or "" where they have several.
  std::string only_reference() const;
  /// Whether it is the reference wherever there is one.
  bool is_always_reference(std::size_t m) const;
  /// Methods to draw distances of: all but one that is always the reference.
  std::vector<std::size_t> compared_methods() const;

  /// Where its pictures are to stand, and how wide they are then, in pixels.
  report::FigureWidth medium() const { return medium_; }
  int width() const;
  /// What does not vary, for the top of a picture.
  report::FigureTitle title() const;

 private:
  const SweepResults& results_;
  report::FigureWidth medium_;
  std::vector<const PointResult*> by_number_;
};

/// The parameters of the case that are the same at all points, in one line: "c = 0.1, k = 1".
std::string fixed_parameters(const Plan& plan);

}  // namespace fpkcheck::sweep
