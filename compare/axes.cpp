#include "compare/axes.hpp"

#include "problem/equivalent_linearisation.hpp"

namespace fpkcheck::compare {
namespace {

constexpr double kDeviations = 7;
// A tenth (y') or a twentieth (y) of a deviation: the density is nearly straight over one bin.
constexpr int kBins = 140;

}  // namespace

ComparisonAxes comparison_axes(const problem::Problem& problem) {
  const auto bell = problem::equivalent_linearisation(problem);
  const double y_max =
      problem::static_deflection(problem) + kDeviations * bell.displacement_deviation;
  const double v_max = kDeviations * bell.velocity_deviation;
  ComparisonAxes axes;
  for (int k = 0; k <= kBins; ++k) {
    axes.y_edges.push_back(y_max * k / kBins);
    // Symmetric to the last digit and exactly 0 in the middle, where p(y, y') jumps at the wall.
    axes.v_edges.push_back(v_max * (2 * k - kBins) / kBins);
  }
  return axes;
}

const std::vector<double>& edges(const ComparisonAxes& axes, transform::Variable variable) {
  return variable == transform::Variable::y ? axes.y_edges : axes.v_edges;
}

}  // namespace fpkcheck::compare
