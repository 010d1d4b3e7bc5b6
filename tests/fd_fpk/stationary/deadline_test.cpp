#include <gtest/gtest.h>

#include <cmath>

#include "fd_fpk/operator/marginals_and_moments.hpp"
#include "fd_fpk/solve.hpp"
#include "fd_fpk/stationary/direct_solution.hpp"
#include "fd_fpk/stationary/solve_on_one_grid.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::fd_fpk {
namespace {

TEST(SolveDeadline, ABoxIsNotWidenedAfterTheDeadline) {
  const auto p = tests::make_problem({.rate = 0.3, .law = "laplace"});
  const PhasePlaneBox first = initial_box(p, {});
  const PhasePlaneBox late = stationary_box(p, problem::motion_scales(p), {}, base::Deadline(0));
  EXPECT_EQ(late.x1_max, first.x1_max);
  EXPECT_EQ(late.x2_max, first.x2_max);
  EXPECT_GT(stationary_box(p, problem::motion_scales(p), {}, base::Deadline(HUGE_VAL)).x2_max,
            first.x2_max);
}

TEST(SolveDeadline, EvenTheFirstSolveIsAborted) {
  const auto p = tests::paper_case(1);
  const MotionScalesAndComputationalBox scales_and_box{.scales = problem::motion_scales(p)};
  const FiniteVolumeOptions direct{.stepper = StationarySolver::direct};
  const base::Deadline over(0);
  for (const auto& late : {solve_on_one_grid(p, scales_and_box, direct, over).solution,
                           solve_along_characteristics(p, scales_and_box.scales, {}, over).solution,
                           solve_stationary_density(p, {.max_seconds = 1e-6}).solution}) {
    EXPECT_EQ(late.status, transform::Status::failed);
    EXPECT_FALSE(late.density);
    EXPECT_NE(late.reason.find("max_seconds"), std::string::npos) << late.reason;
  }
}

TEST(SolveDeadline, AStepIsAborted) {
  const auto p = tests::paper_case(1);
  const FiniteVolumeOptions options{.equation = DensityEquation::white, .nx = 16, .nv = 32};
  const PlaneDiscretisation on = discretise_density_equation(p, options, initial_box(p, options));
  const auto op = fokker_planck_operator(p, options, on);
  const auto march = [&](double seconds) {
    Preconditioner preconditioner(p, on.excitation, options.impact, on.grid);
    return integrate_to_stationarity(op, preconditioner,
                                     initial_gaussian(on.grid, problem::motion_scales(p)), 1e-10,
                                     20, base::Deadline(seconds));
  };
  const PseudoTransientResult late = march(0);
  EXPECT_TRUE(late.out_of_time);
  EXPECT_EQ(late.steps, 0);
  const PseudoTransientResult in_time = march(HUGE_VAL);
  EXPECT_FALSE(in_time.out_of_time);
  EXPECT_GT(in_time.steps, 1);
  EXPECT_LE(in_time.residual, 1e-10);
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
