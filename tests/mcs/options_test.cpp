#include "mcs/options.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "base/input_error.hpp"
#include "mcs/solve.hpp"
#include "paper_cases.hpp"
#include "refusal.hpp"

namespace fpkcheck::mcs {
namespace {

template <class Change>
void expect_options_refused(Change change, const std::string& key) {
  SimulationOptions bad;
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
  expect_options_refused([](auto& o) { o.equation = DensityEquation::km4; }, "equation");
  expect_options_refused([](auto& o) { o.time = -1; }, "time");
  expect_options_refused([](auto& o) { o.time = 0; }, "time");
  expect_options_refused([&](auto& o) { o.time = nan; }, "time");
  expect_options_refused([](auto& o) { o.seed = std::uint64_t{1} << 63; }, "seed");
  expect_options_refused([](auto& o) { o.threads = -1; }, "threads");
  expect_options_refused([](auto& o) { o.threads = 0; }, "threads");
  expect_options_refused([](auto& o) { o.threads = 100000; }, "threads");
  expect_options_refused([](auto& o) { o.streams = 0; }, "streams");
  expect_options_refused([](auto& o) { o.streams = 7; }, "streams");
  expect_options_refused([](auto& o) { o.streams = 1000000; }, "streams");
  expect_options_refused([](auto& o) { o.step = -0.1; }, "step");
  expect_options_refused([](auto& o) { o.step = 1.3; }, "step");
  expect_options_refused([&](auto& o) { o.step = nan; }, "step");
  expect_options_refused([](auto& o) { o.samples = -1; }, "samples");
  expect_options_refused([&](auto& o) { o.samples = nan; }, "samples");
  expect_options_refused([](auto& o) { o.target_error = 1; }, "target_error");
  expect_options_refused([&](auto& o) { o.target_error = nan; }, "target_error");
  expect_options_refused([](auto& o) { o.accuracy = 0; }, "accuracy");
  expect_options_refused([&](auto& o) { o.accuracy = nan; }, "accuracy");
  expect_options_refused([](auto& o) { o.white_step = 0.6; }, "white_step");
  expect_options_refused([](auto& o) { o.y_edges = {0}; }, "y_edges");
  expect_options_refused([](auto& o) { o.y_edges = {0, 1, 1}; }, "y_edges");
  expect_options_refused([](auto& o) { o.y_edges = {0.1, 1}; }, "y_edges");
  expect_options_refused([](auto& o) { o.v_edges = {1, 0}; }, "v_edges");
  expect_options_refused([&](auto& o) { o.v_edges = {0, nan}; }, "v_edges");
  SimulationOptions one_stream;
  one_stream.streams = 1;
  EXPECT_THROW(simulate_stationary_density(tests::paper_case(1), one_stream), InputError);
  EXPECT_NO_THROW(validate({}));
}

TEST(Options, ComeBackFromTheirValues) {
  const SimulationOptions changed{.equation = DensityEquation::white,
                                  .time = 12345.5,
                                  .samples = 2e6,
                                  .target_error = 1e-3,
                                  .accuracy = 0.1,
                                  .seed = 9223372036854775807u,
                                  .threads = 3,
                                  .streams = 64,
                                  .step = 0.7,
                                  .white_step = 0.04,
                                  .tails = true,
                                  .controlled = true};
  const auto values = solver_option_descriptions().values(changed);
  const auto usual = solver_option_descriptions().values({});
  ASSERT_EQ(values.size(), usual.size());
  for (std::size_t k = 0; k < values.size(); ++k) {
    EXPECT_NE(values[k].value, usual[k].value) << values[k].name;
  }
  EXPECT_EQ(
      solver_option_descriptions().values(solver_option_descriptions().read(values, "options")),
      values);
  EXPECT_EQ(
      solver_option_descriptions().values(solver_option_descriptions().read(usual, "options")),
      usual);
}

TEST(Options, HaveTheNamesAndFlagsOfFilesAndTheCommandLine) {
  std::vector<std::string> names, flags;
  for (const auto& parameter : solver_option_descriptions().parameters()) {
    names.push_back(parameter.name);
    flags.push_back(parameter.flag);
    EXPECT_FALSE(parameter.help.empty()) << parameter.name;
  }
  EXPECT_EQ(names, (std::vector<std::string>{"equation", "time", "samples", "target_error",
                                             "accuracy", "seed", "threads", "streams", "step",
                                             "white_step", "tails", "controlled"}));
  EXPECT_EQ(flags, (std::vector<std::string>{"equation", "time", "samples", "target-error",
                                             "accuracy", "seed", "threads", "streams", "step",
                                             "white-step", "tails", "controlled"}));
}

TEST(Options, OfTheCommandLineAreRefusedByTheirFlag) {
  const auto refusal = [](const char* name, const char* text) -> std::string {
    SimulationOptions options;
    return tests::refusal([&] {
      solver_option_descriptions().parse(options, *solver_option_descriptions().find(name), text,
                                         std::string("--") + name);
    });
  };
  EXPECT_EQ(refusal("seed", "-1"), "--seed -1 (must be zero or positive)");
  EXPECT_EQ(refusal("equation", "km4"), "--equation 'km4' (must be one of kf, white)");
  EXPECT_EQ(refusal("seed", "9223372036854775807"), "accepted");
  EXPECT_EQ(refusal("threads", "auto"), "accepted");
}

TEST(Options, HaveAnIdThatLeadsBackToThem) {
  EXPECT_EQ(solution_id({}), "mcs");
  EXPECT_EQ(solution_id({.equation = DensityEquation::white}), "mcs-white");
  for (const char* name : {"mcs", "mcs-white"}) {
    const auto options = options_of(name);
    ASSERT_TRUE(options) << name;
    EXPECT_EQ(solution_id(*options), name);
    const auto who = solution_identity(*options);
    EXPECT_EQ(who.id, name);
    EXPECT_EQ(who.method, "mcs");
    EXPECT_EQ(who.equation, options->equation);
    EXPECT_EQ(who.impact, problem::ImpactCondition::exact);
    EXPECT_EQ(who.role, transform::SolutionRole::simulation);
  }
  EXPECT_FALSE(options_of("mcs-km4"));
  EXPECT_FALSE(options_of("fd-kf"));
}

}  // namespace
}  // namespace fpkcheck::mcs
