#include "epc/moment/solve.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "epc/form/allowed.hpp"
#include "epc/form/put_density.hpp"
#include "epc/half_plane/report.hpp"
#include "epc/half_plane/search.hpp"
#include "epc/moment/density.hpp"
#include "epc/moment/level_density.hpp"
#include "epc/moment/search.hpp"
#include "epc/moment/tail.hpp"
#include "problem/features.hpp"
#include "transform/panel_marginals.hpp"

namespace fpkcheck::epc::moment {
namespace {

using half_plane::Root;
using half_plane::Shape;

// Tolerance on the change of Q_n on more quadrature points, in standard deviations.
constexpr double kQuadratureAllowed = 1e-6;

transform::SmoothDensity density_of(const problem::Problem& problem, const Shape& shape,
                                    Tail tail) {
  return density_of(shape.q, EnergyDomain(problem, shape.support),
                    half_plane::confinement_of(shape.level, tail), -shape.log_normalisation);
}

// Reason why a density beyond the paper's class is inadmissible: the confinement alone makes it
// decay. Empty otherwise.
std::string objection_at_level(double level_density, const LeadingForm& form) {
  if (level_density < kLevelDensityAllowed) return "";
  return fmt::format("exp(Q_n) is {:.1e} of its peak at the confinement level (limit {:.0e}), {}",
                     level_density, kLevelDensityAllowed, behaviour(form, "(y, v) / deviations"));
}

std::string objection(double edge_density, const LeadingForm& form) {
  if (edge_density < kEdgeAllowed) return "";
  return fmt::format(
      "the density is {:.1e} of its peak on the edge of its support (limit {:.0e}), {}",
      edge_density, kEdgeAllowed, behaviour(form, "(y, v) / deviations"));
}

}  // namespace

Result solve(const problem::Problem& problem, const Options& options) {
  const Root root = find_root(problem, options);
  Result result = half_plane::reported(root);
  if (!root.failure.empty()) return result;

  auto& [solution, summary] = result;
  const Shape& shape = root.shape;
  const transform::SmoothDensity density = density_of(problem, shape, options.tail);
  const auto marginals = put_density(problem, Impact::map, density, result);
  if (root.previous) {
    auto before = density_of(problem, *root.previous, options.tail);
    before.y_min = density.y_min;  // same panels
    summary.distance_to_previous =
        distance(marginals, transform::panel_marginals(before, density.y_max, density.v_max));
  }
  const Deviations sigma = half_plane::deviations(marginals.moments);
  summary.leading_form =
      leading_form(shape.q, sigma, problem.system.left() ? Plane::half : Plane::whole);
  summary.frame = half_plane::frame_of(shape, options.tail, Variables::physical);
  summary.frame->coordinates = problem.frame;
  const double edge = edge_density(shape, problem, options.tail);
  std::string objected = objection(edge, *summary.leading_form);
  // In the paper's class half_plane::set_status limits the probability beyond the level instead.
  if (objected.empty() && !problem::of_the_paper(problem)) {
    objected = objection_at_level(level_density(shape, problem), *summary.leading_form);
  }
  half_plane::describe(root, options.tail, density, sigma,
                       {.support = contour(EnergyDomain(problem, shape.support)),
                        .level = contour(EnergyDomain(problem, shape.level)),
                        .density = edge},
                       result);
  half_plane::conclude(root, kQuadratureAllowed, objected, result);
  return result;
}

}  // namespace fpkcheck::epc::moment
