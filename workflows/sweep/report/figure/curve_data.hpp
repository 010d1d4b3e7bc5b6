#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "report/figure/script_parts.hpp"
#include "workflows/sweep/report/figure/curves_layout.hpp"
#include "workflows/sweep/report/figure/sweep_view.hpp"

namespace fpkcheck::sweep {

/// The columns of a curve's data block in a gnuplot script.
enum CurveColumn {
  abscissa = 1,
  distance_y,
  distance_ydot,
  mark_type,  ///< filled where the solution is ok, else open
  error_estimate_y,
  error_estimate_ydot,
  moment_y,
  moment_ydot
};

/// The data of the curves of all methods, slice by slice. A CurveData object keeps references to
/// view and layout.
class CurveData {
 public:
  CurveData(const SweepView& view, const CurvesLayout& layout);

  const SweepView& view() const { return view_; }
  const CurvesLayout& layout() const { return layout_; }
  bool has_words() const { return layout_.along.has_words(); }
  std::size_t method_count() const { return looks_.size(); }
  const transform::PlotStyle& plot_style(std::size_t m) const {
    return view_.plan().methods[m].identity.plot_style;
  }
  const report::SeriesStyle& marks(std::size_t m) const { return looks_[m]; }
  double mark_size() const;

  void for_each(const std::function<void(std::size_t point, std::size_t m)>& call) const;
  /// The L1 distance of a method's marginal density to the point's reference; empty for the
  /// reference itself.
  std::optional<double> l1(std::size_t point, std::size_t m, transform::Variable variable) const;
  /// The error estimate of a method at a point; empty if the method has no distance with which the
  /// estimate could be compared.
  std::optional<double> method_error_estimate(std::size_t point, std::size_t m,
                                              transform::Variable variable) const;
  /// The error estimate of the reference of a point.
  std::optional<double> reference_error(std::size_t point, transform::Variable variable) const;
  /// Whether the point has a reference, but the method has no density that can be compared with the
  /// reference.
  bool has_no_density(std::size_t point, std::size_t m) const;
  /// The abscissa of a method's result. On a categorical axis the methods are side by side at each
  /// category.
  double abscissa_of(std::size_t point, std::size_t m) const;

  /// The data blocks $curve_SLICE_METHOD of all curves, with the columns of CurveColumn.
  std::string blocks() const;
  /// The data blocks $floor_SLICE with the columns abscissa, error of the reference in y, and error
  /// of the reference in ydot. On a categorical axis each category has a bar of its own.
  std::string reference_error_blocks() const;

 private:
  double abscissa_of(std::size_t point) const;

  const SweepView& view_;
  const CurvesLayout& layout_;
  std::vector<report::SeriesStyle> looks_;
};

/// The text of a number in a data block; NaN if the number is missing, since gnuplot skips NaN.
std::string data_cell(const std::optional<double>& number);

}  // namespace fpkcheck::sweep
