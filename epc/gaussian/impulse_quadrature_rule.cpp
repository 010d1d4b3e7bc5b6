#include "epc/gaussian/impulse_quadrature_rule.hpp"

#include <cmath>
#include <variant>

#include "numerics/quadrature/composite_gauss.hpp"
#include "problem/impulse_law.hpp"

namespace fpkcheck::epc::gaussian {
namespace {

QuadratureRule quadrature_rule_of(const problem::GaussianLaw& law, int points) {
  QuadratureRule rule = normal_quadrature_rule(2 * points - 1);
  for (double& y : rule.nodes) y = law.mean + law.deviation * y;
  return rule;
}

QuadratureRule quadrature_rule_of(const problem::LaplaceLaw& law, int points) {
  const QuadratureRule half = exponential_quadrature_rule(2 * points - 1);
  QuadratureRule rule;
  for (std::size_t i = 0; i < half.nodes.size(); ++i) {
    for (const int side : {-1, 1}) {
      rule.nodes.push_back(law.mean + side * law.scale * half.nodes[i]);
      rule.weights.push_back(half.weights[i] / 2);
    }
  }
  return rule;
}

QuadratureRule quadrature_rule_of(const problem::ExponentialLaw& law, int points) {
  QuadratureRule rule = exponential_quadrature_rule(2 * points - 1);
  for (double& y : rule.nodes) y = law.mean + law.scale * (y - 1);
  return rule;
}

QuadratureRule quadrature_rule_of(const problem::TwoPointLaw& law, int) {
  return {.nodes = {law.mean - law.deviation, law.mean + law.deviation}, .weights = {0.5, 0.5}};
}

QuadratureRule quadrature_rule_of(const problem::UniformLaw& law, int points) {
  QuadratureRule rule = uniform_quadrature_rule(2 * points - 1);
  for (double& y : rule.nodes) y = law.mean + law.half_width * y;
  return rule;
}

}  // namespace

QuadratureRule impulse_quadrature_rule(const problem::ImpulseLaw& law, int points) {
  return std::visit(
      [&](const auto& kind) {
        if constexpr (requires { quadrature_rule_of(kind, points); }) {
          return quadrature_rule_of(kind, points);
        } else {
          return piecewise_impulse_quadrature_rule(law);
        }
      },
      law.kind());
}

QuadratureRule piecewise_impulse_quadrature_rule(const problem::ImpulseLaw& law) {
  QuadratureRule rule;
  const auto add = [&](double amplitude, double probability) {
    rule.nodes.push_back(amplitude);
    rule.weights.push_back(probability);
  };
  for (const auto& [amplitude, probability] : law.atoms()) add(amplitude, probability);
  const std::vector<double> pieces = law.density_breakpoints();
  for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
    const double from = pieces[i], to = pieces[i + 1];
    const int panels = static_cast<int>(std::ceil((to - from) / law.deviation()));
    for (const auto& [at, weight] : numerics::composite_gauss_points(from, to, panels)) {
      add(at, weight * law.density(at));
    }
  }
  return rule;
}

}  // namespace fpkcheck::epc::gaussian
