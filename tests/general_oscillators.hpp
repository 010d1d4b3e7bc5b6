#pragma once

#include "problem/problem.hpp"

/// Problems outside the class of the paper, shared by tests.
namespace fpkcheck::tests {

inline problem::ImpulseTrain gaussian_impulses(double rate, double intensity, double mean = 0) {
  return problem::ImpulseTrain(
      {.arrival_rate = rate, .law = "gaussian", .intensity = intensity, .mean = mean});
}

/// A problem with white noise and without impulses.
inline problem::Problem with_noise(const problem::System& system, double intensity) {
  return {.name = "test", .system = system, .impulses = {}, .noise = {intensity}};
}

inline problem::Problem with_impulses(const problem::System& system,
                                      const problem::ImpulseTrain& impulses) {
  return {.name = "test", .system = system, .impulses = impulses};
}

/// The problem in the wall coordinates of the solvers.
inline problem::Problem in_wall_coordinates(const problem::Problem& problem) {
  return problem::to_wall_coordinates(problem::wall_frame(problem.system), problem);
}

}  // namespace fpkcheck::tests
