#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "report/figure/script_parts.hpp"
#include "workflows/sweep/report/figure/curves_layout.hpp"
#include "workflows/sweep/report/figure/sweep_view.hpp"

namespace fpkcheck::sweep {

/// Columns of a curve's data in a script.
enum CurveColumn {
  abscissa = 1,
  distance_y,
  distance_ydot,
  mark_type,  ///< filled where the answer is ok, else open
  own_y,
  own_ydot,
  moment_y,
  moment_ydot
};

/// The curves of all methods, slice by slice, as data. Refers to what it is made of.
class CurveData {
 public:
  CurveData(const SweepView& view, const CurvesLayout& layout);

  const SweepView& view() const { return view_; }
  const CurvesLayout& layout() const { return layout_; }
  bool is_words() const { return layout_.along.is_words(); }
  std::size_t methods() const { return looks_.size(); }
  const transform::Look& look(std::size_t m) const { return view_.plan().methods[m].identity.look; }
  const report::SeriesLook& marks(std::size_t m) const { return looks_[m]; }
  double mark_size() const;

  void for_each(const std::function<void(std::size_t point, std::size_t m)>& call) const;
  /// Distance to the point's reference; none of the reference itself.
  std::optional<double> l1(std::size_t point, std::size_t m, transform::Variable variable) const;
  /// What the method states of it; nothing without a distance to set it against.
  std::optional<double> own_error(std::size_t point, std::size_t m,
                                  transform::Variable variable) const;
  /// What the point's reference states of its own.
  std::optional<double> floor(std::size_t point, transform::Variable variable) const;
  /// There is a reference, but of this method nothing to compare with it.
  bool has_no_density(std::size_t point, std::size_t m) const;
  /// Where a method's answer stands; methods stand side by side at a word.
  double abscissa_of(std::size_t point, std::size_t m) const;

  /// $curve_SLICE_METHOD, with CurveColumns.
  std::string blocks() const;
  /// $floor_SLICE: abscissa, error of the reference in y and ydot. A word has a bar of its own.
  std::string floor_blocks() const;

 private:
  double abscissa_of(std::size_t point) const;

  const SweepView& view_;
  const CurvesLayout& layout_;
  std::vector<report::SeriesLook> looks_;
};

/// As a cell of data: gnuplot leaves out what is NaN.
std::string data_cell(const std::optional<double>& number);

}  // namespace fpkcheck::sweep
