#include "epc/admissibility.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "problem/energy_balance.hpp"
#include "transform/zhuravlev.hpp"

namespace fpkcheck::epc {
namespace {

using transform::Status;

transform::SmoothDensity density_of(const Polynomial& q, const Support& support) {
  const double constant = std::exp(-support.peak()) / support.integral();  // C of paper (17)
  return transform::physical_density({.value =
                                          [q, support, constant](double x1, double x2) {
                                            return support.contains(x1, x2)
                                                       ? constant * std::exp(q(x1, x2))
                                                       : 0;
                                          },
                                      .x1_max = support.x1_max(),
                                      .x2_max = support.x2_max()});
}

// Why a root is no density of the kind asked for; empty when it is.
std::string objection(const Support& support, const LeadingForm& form, double energy_residual) {
  if (!(support.edge_ratio() < Support::kEdgeAllowed)) {
    const std::string rise =
        form.negative ? std::string("though Q_n falls in the end")
                      : fmt::format(
                            "and Q_n rises in the end along {:.0f} % of all directions, along "
                            "(x1/sigma1, x2/sigma2) = ({:.2f}, {:.2f}) from radius {:.2f} on",
                            100 * form.rising_share, form.worst.x1, form.worst.x2, form.rises_from);
    return fmt::format(
        "the density is {:.1e} of its peak on the edge of its support (allowed {:.0e}), {}",
        support.edge_ratio(), Support::kEdgeAllowed, rise);
  }
  if (!(std::abs(energy_residual) <= kEnergyAllowed)) {
    return fmt::format(
        "the root misses the stationary balance of power by {:.0f} % of the input (allowed "
        "{:.0f} %), so it is near no stationary density",
        100 * std::abs(energy_residual), 100 * kEnergyAllowed);
  }
  return "";
}

}  // namespace

void judge(const problem::Problem& problem, const Polynomial& q, const Deviations& sigma,
           Result& result) {
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
  solution.mass = transform::expectation(density, [](double, double) { return 1.0; });
  solution.moments = transform::moments(density);
  solution.energy_residual =
      problem::energy_residual(problem, problem::Impact::delta,
                               {.mean_velocity = solution.moments.v1,
                                .mean_square_velocity = solution.moments.v2,
                                .impact_energy_flux = transform::impact_flux(density, 3)});
  solution.density = density;
  solution.reason = objection(support, form, solution.energy_residual);
  solution.status = solution.reason.empty() ? Status::ok : Status::inadmissible;
}

}  // namespace fpkcheck::epc
