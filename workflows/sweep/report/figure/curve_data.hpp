#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "report/figure/script_parts.hpp"
#include "workflows/sweep/report/figure/curves_layout.hpp"
#include "workflows/sweep/report/figure/sweep_view.hpp"

namespace fpkcheck::sweep {

/// Columns of a curve's data block in a script.
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

/// Data of the curves of all methods, slice by slice. Keeps references to view and layout.
class CurveData {
 public:
  CurveData(const SweepView& view, const CurvesLayout& layout);

  const SweepView& view() const { return view_; }
  const CurvesLayout& layout() const { return layout_; }
  bool is_words() const { return layout_.along.is_words(); }
  std::size_t methods() const { return looks_.size(); }
  const transform::PlotStyle& plot_style(std::size_t m) const {
    return view_.plan().methods[m].identity.plot_style;
  }
  const report::SeriesStyle& marks(std::size_t m) const { return looks_[m]; }
  double mark_size() const;

  void for_each(const std::function<void(std::size_t point, std::size_t m)>& call) const;
  /// Distance to the point's reference; empty for the reference itself.
  std::optional<double> l1(std::size_t point, std::size_t m, transform::Variable variable) const;
  /// Error estimate of the method; empty where there is no distance for a comparison.
  std::optional<double> own_error(std::size_t point, std::size_t m,
                                  transform::Variable variable) const;
  /// Error estimate of the point's reference.
  std::optional<double> reference_error(std::size_t point, transform::Variable variable) const;
  /// True where the point has a reference, but the method has no density to compare with it.
  bool has_no_density(std::size_t point, std::size_t m) const;
  /// Abscissa of a method's result; methods are side by side over a word.
  double abscissa_of(std::size_t point, std::size_t m) const;

  /// Data blocks $curve_SLICE_METHOD, with the columns of CurveColumn.
  std::string blocks() const;
  /// Data blocks $floor_SLICE: abscissa, error of the reference in y and ydot. Each word has its
  /// own bar.
  std::string reference_error_blocks() const;

 private:
  double abscissa_of(std::size_t point) const;

  const SweepView& view_;
  const CurvesLayout& layout_;
  std::vector<report::SeriesStyle> looks_;
};

/// Cell of a data block; gnuplot skips NaN.
std::string data_cell(const std::optional<double>& number);

}  // namespace fpkcheck::sweep
