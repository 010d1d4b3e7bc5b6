#include "epc/impulse_rule.hpp"

#include <variant>

namespace fpkcheck::epc {
namespace {

Rule rule_of(const problem::GaussianLaw& law, int points) {
  Rule rule = normal_rule(2 * points - 1);
  for (double& y : rule.nodes) y = law.mean + law.deviation * y;
  return rule;
}

Rule rule_of(const problem::LaplaceLaw& law, int points) {
  const Rule half = exponential_rule(2 * points - 1);
  Rule rule;
  for (std::size_t i = 0; i < half.nodes.size(); ++i) {
    for (const int side : {-1, 1}) {
      rule.nodes.push_back(law.mean + side * law.scale * half.nodes[i]);
      rule.weights.push_back(half.weights[i] / 2);
    }
  }
  return rule;
}

Rule rule_of(const problem::TwoPointLaw& law, int) {
  return {.nodes = {law.mean - law.deviation, law.mean + law.deviation}, .weights = {0.5, 0.5}};
}

Rule rule_of(const problem::UniformLaw& law, int points) {
  Rule rule = uniform_rule(2 * points - 1);
  for (double& y : rule.nodes) y = law.mean + law.half_width * y;
  return rule;
}

}  // namespace

Rule impulse_rule(const problem::ImpulseLaw& law, int points) {
  return std::visit([&](const auto& kind) { return rule_of(kind, points); }, law.kind());
}

}  // namespace fpkcheck::epc
