#pragma once

#include <string>

#include "problem/problem.hpp"

/// Problems shared by tests.
namespace fpkcheck::tests {

struct Parameters {
  double damping = 0.1, stiffness = 1.0, cubic = 0.1, restitution = 0.98;
  double rate = 1.0, intensity = 0.1, mean = 0.0;
  std::string law = "gaussian";
};

/// A problem with the paper's oscillator; by default case 1 of the paper.
inline problem::Problem make_problem(const Parameters& p = {}) {
  return {"test",
          problem::System({.damping = p.damping,
                           .stiffness = p.stiffness,
                           .cubic = p.cubic,
                           .restitution = p.restitution}),
          problem::ImpulseTrain(
              {.arrival_rate = p.rate, .law = p.law, .intensity = p.intensity, .mean = p.mean})};
}

/// Cases 1 .. 4 of Table 1 of the paper.
inline problem::Problem paper_case(int number) {
  return make_problem({.cubic = number <= 2 ? 0.1 : 1.0, .intensity = number % 2 ? 0.1 : 1.0});
}

}  // namespace fpkcheck::tests
