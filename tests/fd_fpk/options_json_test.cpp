#include <gtest/gtest.h>

#include "fd_fpk/summary.hpp"
#include "saved_options.hpp"

namespace fpkcheck::fd_fpk {
namespace {

TEST(Options, ComeBackFromASummary) {
  tests::expect_round_trip(Options{.equation = Equation::km4,
                                   .impact = problem::Impact::delta,
                                   .stepper = Stepper::direct,
                                   .order = 7,
                                   .refinement = 1.3,
                                   .origin_refinement = 4,
                                   .nx = 60,
                                   .nv = 80,
                                   .x1_max = 0.1 + 0.2,
                                   .x2_max = 5.5,
                                   .regularisation_length = 0.31,
                                   .wall_density = 2e-7,
                                   .refine_unresolved = false,
                                   .error_estimate = true,
                                   .tolerance = 1.1e-5,
                                   .residual_tolerance = 2.2e-9},
                           options_from_json);
}

TEST(Options, EveryEquationComesBack) {
  for (const auto equation : {Equation::white, Equation::km4, Equation::km4_pade, Equation::kf}) {
    EXPECT_EQ(options_from_json(to_json(Options{.equation = equation})).equation, equation);
  }
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
