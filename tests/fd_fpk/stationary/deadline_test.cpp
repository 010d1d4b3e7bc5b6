#include <gtest/gtest.h>

#include <cmath>

#include "fd_fpk/stationary/direct_solution.hpp"
#include "fd_fpk/stationary/pseudo_transient.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::fd_fpk {
namespace {

TEST(DeadlineOfASolution, ABoxIsNotWidenedAfterIt) {
  const auto p = tests::make_problem({.rate = 0.3, .law = "laplace"});
  const Box first = initial_box(p, {});
  const Box late = stationary_box(p, {}, Deadline(0));
  EXPECT_EQ(late.x1_max, first.x1_max);
  EXPECT_EQ(late.x2_max, first.x2_max);
  EXPECT_GT(stationary_box(p, {}, Deadline(HUGE_VAL)).x2_max, first.x2_max);
}

TEST(DeadlineOfASolution, NoStepIsTakenAfterItButTheFirst) {
  const auto p = tests::paper_case(1);
  const Options options{.equation = Equation::white, .nx = 16, .nv = 32};
  const Discretisation on = discretise(p, options, initial_box(p, options));
  const auto op = fokker_planck_operator(p, options, on);
  const auto march = [&](double seconds) {
    Preconditioner preconditioner(p, on.excitation, options.impact, on.grid);
    return march_to_stationarity(op, preconditioner, gaussian_start(on.grid, p), 1e-10,
                                 {.first_step = 10, .longest_step = 1e4}, Deadline(seconds));
  };
  const March late = march(0);
  EXPECT_TRUE(late.out_of_time);
  EXPECT_EQ(late.steps, 1);
  const March in_time = march(HUGE_VAL);
  EXPECT_FALSE(in_time.out_of_time);
  EXPECT_GT(in_time.steps, 1);
  EXPECT_LE(in_time.residual, 1e-10);
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
