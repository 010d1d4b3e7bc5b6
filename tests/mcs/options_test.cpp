#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "mcs/plan.hpp"
#include "mcs/simulate.hpp"
#include "paper_cases.hpp"
#include "problem/equivalent_linearisation.hpp"
#include "problem/input_error.hpp"

namespace fpkcheck::mcs {
namespace {

template <class Change>
void expect_refused(Change change, const std::string& key) {
  Options bad;
  change(bad);
  try {
    validate(bad);
    FAIL() << "accepted a bad " << key;
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("mcs." + key), std::string::npos) << error.what();
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
  }
}

TEST(Options, OutOfRangeAreRefusedByName) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expect_refused([](auto& o) { o.time = -1; }, "time");
  expect_refused([&](auto& o) { o.time = nan; }, "time");
  expect_refused([](auto& o) { o.threads = -1; }, "threads");
  expect_refused([](auto& o) { o.threads = 100000; }, "threads");
  expect_refused([](auto& o) { o.streams = 0; }, "streams");
  expect_refused([](auto& o) { o.streams = 7; }, "streams");
  expect_refused([](auto& o) { o.streams = 1000000; }, "streams");
  expect_refused([](auto& o) { o.step = -0.1; }, "step");
  expect_refused([](auto& o) { o.step = 1.3; }, "step");
  expect_refused([&](auto& o) { o.step = nan; }, "step");
  expect_refused([](auto& o) { o.samples = -1; }, "samples");
  expect_refused([&](auto& o) { o.samples = nan; }, "samples");
  expect_refused([](auto& o) { o.target_error = 1; }, "target_error");
  expect_refused([&](auto& o) { o.target_error = nan; }, "target_error");
  expect_refused([](auto& o) { o.white_step = 0.6; }, "white_step");
  expect_refused([](auto& o) { o.y_edges = {0}; }, "y_edges");
  expect_refused([](auto& o) { o.y_edges = {0, 1, 1}; }, "y_edges");
  expect_refused([](auto& o) { o.y_edges = {0.1, 1}; }, "y_edges");
  expect_refused([](auto& o) { o.v_edges = {1, 0}; }, "v_edges");
  expect_refused([&](auto& o) { o.v_edges = {0, nan}; }, "v_edges");
  Options one_stream;
  one_stream.streams = 1;
  EXPECT_THROW(simulate(tests::paper_case(1), one_stream), InputError);
  EXPECT_NO_THROW(validate({}));
}

TEST(Options, LeftOutAreChosenFromTheEquivalentLinearisation) {
  const auto problem = tests::paper_case(4);
  const auto linear = problem::equivalent_linearisation(problem);
  const Plan plan = make_plan(problem, {});
  const double time = plan.round_time() * static_cast<double>(plan.rounds) * plan.streams;
  EXPECT_NEAR(time * problem::slowest_decay(linear), 1.6e6, 4e3);
  EXPECT_NEAR(plan.burn_in * problem::slowest_decay(linear), 20, 1e-12);
  EXPECT_EQ(plan.y_bins.bins(), 140u);
  EXPECT_EQ(plan.v_bins.bins(), 140u);
  EXPECT_EQ(plan.y_bins.edges().front(), 0.0);
  EXPECT_NEAR(plan.y_bins.edges().back(), 7 * linear.displacement_deviation, 1e-12);
  EXPECT_NEAR(plan.v_bins.edges().front(), -7 * linear.velocity_deviation, 1e-12);
  EXPECT_GE(plan.threads, 1);
}

}  // namespace
}  // namespace fpkcheck::mcs
