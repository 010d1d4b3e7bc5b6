#include "epc/admissibility.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "epc/put_density.hpp"
#include "problem/equivalent_linearisation.hpp"
#include "transform/zhuravlev.hpp"

namespace fpkcheck::epc {
namespace {

using transform::Status;

transform::SmoothDensity density_of(const Polynomial& q, const Support& support) {
  const double constant = std::exp(-support.peak()) / support.integral();  // C of paper (17)
  const auto plane = [q, support](double x1, double x2) {
    return support.contains(x1, x2) ? std::exp(q(x1, x2)) : 0;
  };
  const bool even =
      std::ranges::all_of(q.terms(), [](const Term& t) { return (t.x1 + t.x2) % 2 == 0; });
  if (even) {  // both points of (5) carry the same density
    return {[plane, constant](double y, double v) { return 2 * constant * plane(y, v); },
            support.x1_max(), support.x2_max()};
  }
  return transform::physical_density(
      {.value = [plane, constant](double x1, double x2) { return constant * plane(x1, x2); },
       .x1_max = support.x1_max(),
       .x2_max = support.x2_max()});
}

// What Q_n does at infinity, paper (19).
std::string behaviour(const LeadingForm& form) {
  if (form.negative) return "though Q_n falls in the end";
  return fmt::format(
      "and Q_n rises in the end along {:.0f} % of all directions, along (x1/sigma1, x2/sigma2) = "
      "({:.2f}, {:.2f}) from radius {:.2f} on",
      100 * form.rising_share, form.worst.x1, form.worst.x2, form.rises_from);
}

// Why a root is no density of the kind asked for; empty when it is.
std::string objection(const Support& support, const LeadingForm& form,
                      const transform::Solution& solution,
                      const std::optional<double>& distance_to_density_before) {
  if (!(support.edge_ratio() < Support::kEdgeAllowed)) {
    return fmt::format(
        "the density is {:.1e} of its peak on the edge of its support (allowed {:.0e}), which cuts "
        "off about {:.1e} of the probability, {}",
        support.edge_ratio(), Support::kEdgeAllowed, support.cut_off(), behaviour(form));
  }
  if (!(std::abs(solution.mass - 1) <= kMassAllowed)) {
    return fmt::format("the density's mass in the box around its support is {:.6f}, not 1",
                       solution.mass);
  }
  if (!(std::abs(solution.energy_residual) <= kEnergyAllowed)) {
    return fmt::format(
        "the root misses the stationary balance of power by {:.0f} % of the input (allowed "
        "{:.0f} %), so it is near no stationary density",
        100 * std::abs(solution.energy_residual), 100 * kEnergyAllowed);
  }
  if (distance_to_density_before.value_or(0) > kDistanceAllowed) {
    return fmt::format(
        "p(y) and p(y') are {:.2f} in L1 from those of the density of order n-2 (allowed {}), so "
        "the root is of another kind",
        *distance_to_density_before, kDistanceAllowed);
  }
  return "";
}

}  // namespace

void judge(const problem::Problem& problem, const Polynomial& q,
           const std::optional<Polynomial>& previous, Result& result) {
  const Deviations sigma = deviations(problem::equivalent_linearisation(problem));
  const Support support(q, sigma);
  const LeadingForm form = leading_form(q, sigma);
  auto& [solution, summary] = result;
  summary.coefficients = q.terms();
  summary.leading_form = form;
  summary.support = {.least_radius = support.least_radius(),
                     .greatest_radius = support.greatest_radius(),
                     .y_max = support.x1_max(),
                     .v_max = support.x2_max(),
                     .edge_density = support.edge_ratio(),
                     .cut_off = support.cut_off()};

  const transform::SmoothDensity density = density_of(q, support);
  const transform::PanelMarginals marginals =
      put_density(problem, problem::Impact::delta, density, solution);
  std::optional<double> distance_to_density_before;
  if (previous) {
    const Support before(*previous, sigma);
    summary.distance_to_previous = distance(
        marginals,
        transform::panel_marginals(density_of(*previous, before), density.y_max, density.v_max));
    if (before.edge_ratio() < Support::kEdgeAllowed) {
      distance_to_density_before = summary.distance_to_previous;
    }
  }
  solution.reason = objection(support, form, solution, distance_to_density_before);
  solution.status = solution.reason.empty() ? Status::ok : Status::inadmissible;
}

std::string half_plane_objection(int order, const transform::Solution& solution,
                                 const Summary& summary) {
  constexpr double kBeyondAllowed = 1e-3;
  // A Gaussian, n = 2, need not be near; later orders must.
  const double distance_allowed = order <= 4 ? kDistanceAllowed : kSettledDistance;
  if (!(std::abs(solution.mass - 1) <= kMassAllowed)) {
    return fmt::format(
        "its mass is {:.5f} by panels over the support (allowed 1 +- {:.0e}): the density has a spike "
        "that they miss, and moments and marginals with it",
        solution.mass, kMassAllowed);
  }
  if (summary.moment && !(summary.moment->beyond_level <= kBeyondAllowed)) {
    return fmt::format(
        "about {:.1e} of the probability lies where the confinement of Q_n begins, or beyond "
        "(allowed {:.0e}), which shapes it",
        summary.moment->beyond_level, kBeyondAllowed);
  }
  if (summary.distance_to_previous && !(*summary.distance_to_previous <= distance_allowed)) {
    return fmt::format(
        "its marginals are L1 {:.2f} from those of order {} (allowed {:.1f}): the orders have not "
        "settled",
        *summary.distance_to_previous, order - 2, distance_allowed);
  }
  return "";
}

}  // namespace fpkcheck::epc
