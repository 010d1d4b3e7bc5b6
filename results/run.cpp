#include "results/run.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "results/joint_netcdf.hpp"

namespace fpkcheck::results {
namespace {

const DensityCurve* find_density_curve(const std::vector<DensityCurve>& curves,
                                       std::string_view solution,
                                       transform::StateVariable variable) {
  const auto found = std::ranges::find_if(curves, [&](const DensityCurve& curve) {
    return curve.solution == solution && curve.variable == variable;
  });
  return found == curves.end() ? nullptr : &*found;
}

// Returns the common width of all bins of a marginal density; empty if the widths differ.
std::optional<double> common_bin_width(const std::vector<double>& centres) {
  if (centres.size() < 2) return std::nullopt;
  constexpr double kRounding = 1e-6;
  const double width = (centres.back() - centres.front()) / static_cast<double>(centres.size() - 1);
  for (std::size_t k = 1; k < centres.size(); ++k) {
    if (std::abs(centres[k] - centres[k - 1] - width) > kRounding * width) return std::nullopt;
  }
  return width;
}

}  // namespace

std::vector<double> bin_widths(const DensityCurve& curve) {
  const auto& centres = curve.abscissa;
  if (const auto width = common_bin_width(centres)) return std::vector(centres.size(), *width);
  std::vector<double> widths(centres.size());
  // The bin widths are computed outwards from the bin edge at 0, separately on each side.
  const auto outwards = [](auto centre, auto end, auto width) {
    for (double edge = 0; centre != end; ++centre, ++width) {
      *width = 2 * (std::abs(*centre) - edge);
      edge += *width;
    }
  };
  const auto above = std::ranges::upper_bound(centres, 0.0);
  const auto width = widths.begin() + (above - centres.begin());
  outwards(above, centres.end(), width);
  outwards(std::make_reverse_iterator(above), centres.rend(), std::make_reverse_iterator(width));
  return widths;
}

const DensityCurve* CaseResult::marginal_curve(std::string_view solution,
                                               transform::StateVariable variable) const {
  return find_density_curve(curves, solution, variable);
}

const DensityCurve* CaseResult::smooth_curve(std::string_view solution,
                                             transform::StateVariable variable) const {
  return find_density_curve(smooth, solution, variable);
}

const MomentErrorEstimate* CaseResult::moment_error_estimate(std::string_view solution) const {
  const auto found =
      std::ranges::find(moment_error_estimates, solution, &MomentErrorEstimate::solution);
  return found == moment_error_estimates.end() ? nullptr : &*found;
}

const MomentErrorSource* CaseResult::moment_error_source(std::string_view solution,
                                                         std::string_view moment) const {
  const auto found = std::ranges::find_if(error_sources, [&](const MomentErrorSource& source) {
    return source.solution == solution && source.moment == moment;
  });
  return found == error_sources.end() ? nullptr : &*found;
}

ProgramInfo current_program(const std::string& command) {
  return {"fpkcheck", FPKCHECK_VERSION, command};
}

DensityCurve make_density_curve(compare::SolutionMarginalDensity&& found) {
  auto& [solution, variable, marginal] = found;
  std::vector<double> centres;
  for (std::size_t b = 0; b < marginal.size(); ++b) centres.push_back(marginal.bin_centre(b));
  return {std::move(solution),       variable,
          std::move(centres),        std::move(marginal.density),
          std::move(marginal.lower), std::move(marginal.upper)};
}

CaseResult make_case_result(const problem::Problem& problem, const compare::ComparisonBins& axes,
                            std::vector<transform::Solution> solutions) {
  auto comparison = compare::compare_solutions(axes, solutions);
  CaseResult result{.problem = problem,
                    .solutions = std::move(solutions),
                    .pairs = std::move(comparison.pairs),
                    .budget = std::move(comparison.budget)};
  for (auto& found : comparison.marginals)
    result.curves.push_back(make_density_curve(std::move(found)));
  for (auto& found : comparison.smooth)
    result.smooth.push_back(make_density_curve(std::move(found)));
  result.joints = joint_densities_on_comparison_cells(axes, result.solutions);
  result.update_assessment();
  return result;
}

}  // namespace fpkcheck::results
