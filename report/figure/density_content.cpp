#include "report/figure/density_content.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>

namespace fpkcheck::report {
namespace {

using results::CaseResult;
using results::DensityCurve;
using transform::StateVariable;

// Returns the curve of the reference solution over smooth bins, or null unless this curve has
// confidence intervals in all bins.
const DensityCurve* reference_curve_over_smooth_bins(const CaseResult& case_result,
                                                     const std::string& reference,
                                                     StateVariable variable) {
  const DensityCurve* curve = case_result.smooth_curve(reference, variable);
  if (curve == nullptr) return nullptr;
  const auto is_complete = [&](const std::vector<double>& ends) {
    return ends.size() == curve->density.size();
  };
  return is_complete(curve->lower) && is_complete(curve->upper) ? curve : nullptr;
}

// Returns the id of the reference solution of a case. The returned id is empty if the case has no
// reference solution, or if the reference solution lacks the curve of a marginal density.
std::string reference_id(const CaseResult& case_result) {
  const auto* reference = case_result.reference_solution();
  if (reference == nullptr) return "";
  const bool is_complete = std::ranges::all_of(transform::kVariables, [&](StateVariable variable) {
    return case_result.marginal_curve(reference->id(), variable) != nullptr;
  });
  return is_complete ? reference->id() : "";
}

CurveDifferenceFromReference subtract_reference(const DensityCurve& curve,
                                                const DensityCurve* reference) {
  if (reference == nullptr || curve.abscissa != reference->abscissa) return {};
  CurveDifferenceFromReference result{
      .abscissa = curve.abscissa, .values = {}, .lower = {}, .upper = {}};
  for (std::size_t k = 0; k < curve.density.size(); ++k) {
    const double subtracted = reference->density[k];
    result.values.push_back(curve.density[k] - subtracted);
    if (curve.lower.empty() || curve.upper.empty()) continue;
    result.lower.push_back(curve.lower[k] - subtracted);
    result.upper.push_back(curve.upper[k] - subtracted);
  }
  return result;
}

CurveDifferenceFromReference absolute_smooth_bin_differences(const DensityCurve* curve,
                                                             const DensityCurve& reference) {
  if (curve == nullptr || curve->abscissa != reference.abscissa) return {};
  CurveDifferenceFromReference result{
      .abscissa = reference.abscissa, .values = {}, .lower = {}, .upper = {}};
  for (std::size_t k = 0; k < reference.density.size(); ++k) {
    const double half_width = (reference.upper[k] - reference.lower[k]) / 2;
    result.values.push_back(
        curve == &reference ? half_width : std::abs(curve->density[k] - reference.density[k]));
  }
  return result;
}

// Returns the axis ranges of the differences between density curves and the curve of the reference
// solution. A logarithmic axis contains the differences of all curves from the reference. A linear
// axis of differences contains only solutions with status ok or inaccurate, since a single outlier
// would compress all other curves. If no solution has the status ok or inaccurate, the linear axis
// of differences contains all curves.
MarginalAxisRanges axis_ranges_of_differences(std::span<const DrawnDensityCurve> curves,
                                              bool logarithmic) {
  std::vector<DrawnDensityCurve> compared_curves;
  std::ranges::copy_if(curves, std::back_inserter(compared_curves), [&](const auto& drawn) {
    return logarithmic || drawn.solution->has_status_ok() ||
           drawn.solution->status == transform::Status::inaccurate;
  });
  return compared_curves.empty() ? density_axis_ranges(curves)
                                 : density_axis_ranges(compared_curves);
}

MarginalDensityCurves marginal_curves(const CaseResult& case_result, StateVariable variable,
                                      const std::string& reference,
                                      const std::optional<std::set<std::string>>& shown_ids,
                                      const std::optional<std::set<std::string>>& visible_ids) {
  MarginalDensityCurves marginal{variable, {}, {}};
  const DensityCurve *reference_curve = case_result.marginal_curve(reference, variable),
                     *smooth = reference_curve_over_smooth_bins(case_result, reference, variable);
  for (const auto& solution : case_result.solutions) {
    if (shown_ids && !shown_ids->contains(solution.id())) continue;
    if (const DensityCurve* curve = case_result.marginal_curve(solution.id(), variable)) {
      marginal.curves.push_back(
          {&solution, curve,
           smooth == nullptr ? subtract_reference(*curve, reference_curve)
                             : absolute_smooth_bin_differences(
                                   case_result.smooth_curve(solution.id(), variable), *smooth),
           static_cast<std::size_t>(&solution - case_result.solutions.data()),
           visible_ids && !visible_ids->contains(solution.id())});
    }
  }
  std::ranges::stable_sort(marginal.curves, {},
                           [](const auto& drawn) { return drawn.plot_style().layer; });

  std::vector<DrawnDensityCurve> ok_curves;
  std::ranges::copy_if(marginal.curves, std::back_inserter(ok_curves),
                       [](const auto& drawn) { return drawn.solution->has_status_ok(); });
  marginal.ranges = density_axis_ranges(ok_curves.empty() ? marginal.curves : ok_curves);
  std::vector<DrawnDensityCurve> visible_curves;
  std::ranges::copy_if(marginal.curves, std::back_inserter(visible_curves),
                       [](const auto& drawn) { return !drawn.is_hidden; });
  const MarginalAxisRanges of_differences = axis_ranges_of_differences(
      visible_curves.empty() ? marginal.curves : visible_curves, smooth != nullptr);
  marginal.ranges.largest_difference = of_differences.largest_difference;
  marginal.ranges.least_difference = of_differences.least_difference;
  return marginal;
}

DensityFigureContent density_content(const CaseResult& case_result,
                                     const std::optional<std::set<std::string>>& shown_ids,
                                     const std::optional<std::set<std::string>>& visible_ids) {
  DensityFigureContent content{
      .reference = reference_id(case_result), .smooth_differences = false, .marginals = {}};
  content.smooth_differences =
      std::ranges::all_of(transform::kVariables, [&](StateVariable variable) {
        return reference_curve_over_smooth_bins(case_result, content.reference, variable) !=
               nullptr;
      });
  for (const auto variable : transform::kVariables) {
    auto marginal =
        marginal_curves(case_result, variable, content.reference, shown_ids, visible_ids);
    if (!marginal.curves.empty()) content.marginals.push_back(std::move(marginal));
  }
  for (const auto& solution : case_result.solutions) {
    const bool has_curve = std::ranges::any_of(transform::kVariables, [&](StateVariable variable) {
      return case_result.marginal_curve(solution.id(), variable) != nullptr;
    });
    if (has_curve && shown_ids && !shown_ids->contains(solution.id())) ++content.hidden_count;
  }
  return content;
}

}  // namespace

DensityFigureContent density_content_for_picture(
    const CaseResult& case_result, const std::optional<std::set<std::string>>& shown_ids) {
  return density_content(case_result, shown_ids, {});
}

DensityFigureContent density_content_for_page(const CaseResult& case_result,
                                              const std::set<std::string>& visible_ids) {
  DensityFigureContent content = density_content(case_result, {}, visible_ids);
  content.smallest_density = kSmallestDensityOnPage;
  return content;
}

}  // namespace fpkcheck::report
