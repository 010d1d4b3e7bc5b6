#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "problem/problem.hpp"

namespace fpkcheck::tests {

/// The problems of a scan of case 1 over the impulse rate at constant intensity, from one impulse
/// in a thousand decay times to impulses that are equivalent to white noise.
struct RateScan {
  std::vector<double> rates{1e-4, 1e-3, 1e-2, 1e-1, 1, 1e1, 1e2, 1e3, 1e4, 1e5};
  std::vector<std::string> laws{"gaussian", "laplace",     "two_point",
                                "uniform",  "exponential", "gamma"};
  std::vector<double> restitutions{0.5, 0.9, 1};

  std::vector<problem::Problem> problems() const {
    std::vector<problem::Problem> all;
    for (const double rate : rates) {
      for (const auto& law : laws) {
        for (const double r : restitutions) {
          all.push_back({.name = fmt::format("rate {:g}, {}, r = {:g}", rate, law, r),
                         .system = problem::System(
                             {.damping = 0.1, .stiffness = 1, .cubic = 0.1, .restitution = r}),
                         .impulses = problem::ImpulseTrain(
                             {.arrival_rate = rate, .law = law, .intensity = 0.1, .mean = 0})});
        }
      }
    }
    return all;
  }
};

}  // namespace fpkcheck::tests
