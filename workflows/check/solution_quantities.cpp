#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "workflows/check/quantities.hpp"
#include "workflows/check/sampling_tolerance.hpp"

namespace fpkcheck::check {
namespace {

using transform::Solution;

void add_density(const Solution& s, const Tolerances& tolerances, const PartQuantities& density) {
  // Quantities of a simulation are judged in standard errors.
  const auto add = [&](const char* name, QuantityKind otherwise, double number, double error,
                       double scale) {
    Quantity& quantity =
        density.append_number(name, otherwise, number, tolerances.deterministic, scale);
    if (!s.standard_errors) return;
    quantity.kind = QuantityKind::simulated;
    quantity.allowed = tolerances.standard_errors;
    quantity.error = error;
  };
  const auto errors = s.standard_errors.value_or(transform::StandardErrors{});
  for (const auto& [name, symbol, moment, size] : transform::kMoments) {
    // The mean velocity E[y'] is 0 in every stationary state. A value of E[y'] below 1e-3 of the
    // standard deviation of y' is an error of the method, and the last digits of this value are
    // rounding errors.
    const double least = moment == size ? 0 : 1e-3 * std::sqrt(s.moments.*size);
    add(symbol, QuantityKind::moment, s.moments.*moment, errors.moments.*moment,
        std::max(std::abs(s.moments.*moment), least));
  }
  for (const auto& atom : s.atoms) {
    const std::string name = fmt::format("probability of rest at y = {:g}", atom.y);
    add(name.c_str(), QuantityKind::moment, atom.probability, atom.standard_error.value_or(0),
        atom.probability);
  }
  add("mass", QuantityKind::mass, s.mass, standard_error_of_mass(s), 1);
  add("energy residual", QuantityKind::energy, s.energy_residual, errors.energy_residual, 1);
  constexpr double kMinScale = 1e-6;
  density.append_number("smallest density", QuantityKind::detail, s.min_density,
                        tolerances.deterministic, std::max(std::abs(s.min_density), kMinScale));
}

void add_stated_error(const Solution& s, const Tolerances& tolerances,
                      const PartQuantities& stated) {
  const auto add = [&](const std::string& of, double error, double least) {
    constexpr double kMinErrorScale = 0.1;  // as transform::Metric::min_scale
    stated.append_number("error of " + of, QuantityKind::detail, error, tolerances.deterministic,
                         std::max({std::abs(error), least, kMinErrorScale}));
  };
  for (const auto variable : transform::kVariables) {
    add(density_name(variable), l1(*s.error, variable), 0);
  }
  for (const auto& [name, symbol, moment, size] : transform::kMoments) {
    // The error estimate of a moment contains the rounding error of the moment.
    add(symbol, s.error->moments.*moment, std::abs(s.moments.*size));
  }
}

void add_standard_errors(const transform::StandardErrors& errors, const PartQuantities& part) {
  const auto add = [&](const std::string& of, double error) {
    part.append_number("standard error of " + of, QuantityKind::simulated_error, error, 1);
  };
  for (const auto& [name, symbol, moment, size] : transform::kMoments)
    add(symbol, errors.moments.*moment);
  add("energy residual", errors.energy_residual);
}

void add_sampling(const transform::SamplingError& sampling, const PartQuantities& part) {
  for (const auto variable : transform::kVariables) {
    const auto add = [&](const std::string& which, const std::optional<double>& l1) {
      part.append_number(part.name + which + density_name(variable), QuantityKind::simulated_error,
                         l1.value_or(std::numeric_limits<double>::quiet_NaN()), 1);
    };
    add(" of ", expected_l1_error(sampling, variable));
    add(" in 99 of 100 of ", l1_error_quantile_99(sampling, variable));
  }
}

}  // namespace

Quantities solution_quantities(const Solution& s, const Tolerances& tolerances) {
  Quantities quantities;
  const auto part = [&](const char* name, const char* value = "there") {
    return PartQuantities{quantities, s.id(), name}.begin(QuantityKind::status, value);
  };
  const PartQuantities whole = part(kWholeSolution);
  whole.append_word("equation", equation_and_impact_text(s.identity));
  whole.append_word("status", std::string(name(s.status)));
  const PartQuantities density = part("density", s.has_density() ? "one" : "none");
  if (s.has_density()) add_density(s, tolerances, density);
  if (s.error) add_stated_error(s, tolerances, part(kStatedError));
  if (s.standard_errors) add_standard_errors(*s.standard_errors, part("standard errors"));
  if (s.sampling) add_sampling(*s.sampling, part("sampling L1"));
  if (s.smooth_sampling) add_sampling(*s.smooth_sampling, part("sampling L1 in smooth bins"));
  add_metric_quantities(s.metrics, tolerances, whole);
  // The tolerances are adjusted for multiple comparisons. Before this loop the member `allowed`
  // contains the exponents (see add_metric_quantities).
  const auto errors =
      std::ranges::count(quantities, QuantityKind::simulated_error, &Quantity::kind);
  for (Quantity& quantity : quantities) {
    if (quantity.kind != QuantityKind::simulated_error) continue;
    quantity.allowed =
        allowed_error_change(s, static_cast<std::size_t>(errors), quantity.allowed, tolerances);
  }
  return quantities;
}

}  // namespace fpkcheck::check
