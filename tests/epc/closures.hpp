#pragma once

#include <cmath>
#include <map>
#include <utility>

#include "epc/solve.hpp"
#include "problem/equivalent_linearisation.hpp"

/// Helpers for the tests of all formulations.
namespace fpkcheck::tests {

inline epc::ClosureOptions closure_options(epc::Formulation formulation, int order,
                                           std::optional<problem::DensityEquation> equation = {}) {
  return {.order = order, .formulation = formulation, .equation = equation};
}

using Coefficients = std::map<std::pair<int, int>, double>;

inline Coefficients coefficients_by_power(const epc::ClosureSummary& summary) {
  Coefficients result;
  for (const auto& [p, q, a] : summary.coefficients) result[{p, q}] = a;
  return result;
}

/// Returns the coefficients in the plane scaled by the deviations, where the magnitudes of all
/// coefficients are comparable.
inline Coefficients scaled_coefficients_by_power(const epc::ClosureSummary& summary, double sigma1,
                                                 double sigma2) {
  Coefficients table = coefficients_by_power(summary);
  for (auto& [power, a] : table) {
    a *= std::pow(sigma1, power.first) * std::pow(sigma2, power.second);
  }
  return table;
}

}  // namespace fpkcheck::tests
