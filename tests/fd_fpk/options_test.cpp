#include "fd_fpk/options.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "refusal.hpp"

namespace fpkcheck::fd_fpk {
namespace {

// Every option differs from its default and from every other option.
FiniteVolumeOptions changed() {
  return {.equation = DensityEquation::km4,
          .impact = ImpactCondition::delta,
          .stepper = StationarySolver::direct,
          .transport = TransportScheme::upwind,
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
          .error_estimate = true,  // as by default: two flags cannot both differ
          .accuracy = 0.015,
          .max_seconds = 12.5,
          .tolerance = 1.1e-5,
          .residual_tolerance = 2.2e-9};
}

TEST(Options, RoundTripThroughTheirValues) {
  const auto values = solver_option_descriptions().values(changed()),
             defaults = solver_option_descriptions().values({});
  EXPECT_EQ(
      solver_option_descriptions().values(solver_option_descriptions().read(values, "options")),
      values);
  EXPECT_EQ(
      solver_option_descriptions().values(solver_option_descriptions().read(defaults, "options")),
      defaults);
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (values[k].name == "error_estimate") continue;
    EXPECT_NE(values[k].value, defaults[k].value)
        << values[k].name << " has its default value: its round trip is not tested";
    for (std::size_t other = 0; other < k; ++other) {
      EXPECT_NE(values[k].value, values[other].value) << values[k].name;
    }
  }
}

TEST(Options, EquationsRoundTripThroughTheirNames) {
  for (const auto& [equation, name, meaning] : enumerator_names(DensityEquation{})) {
    const auto values = solver_option_descriptions().values({.equation = equation});
    EXPECT_EQ(solver_option_descriptions().read(values, "options").equation, equation) << name;
  }
}

TEST(Options, HaveTheNamesOfFilesAndTheFlagsOfTheCommandLine) {
  const std::vector<std::pair<std::string, std::string>> expected{
      {"equation", "equation"},
      {"impact", "impact"},
      {"stepper", "stepper"},
      {"transport", "transport"},
      {"order", "order"},
      {"refinement", "refinement"},
      {"origin_refinement", "origin-refinement"},
      {"nx", "nx"},
      {"nv", "nv"},
      {"x1_max", "y-max"},
      {"x2_max", "v-max"},
      {"regularisation_length", "regularisation-length"},
      {"wall_density", "wall-density"},
      {"refine_unresolved", ""},
      {"error_estimate", ""},
      {"accuracy", "accuracy"},
      {"max_seconds", "max-seconds"},
      {"tolerance", "tolerance"},
      {"residual_tolerance", "residual"}};
  std::vector<std::pair<std::string, std::string>> found;
  for (const auto& parameter : solver_option_descriptions().parameters())
    found.emplace_back(parameter.name, parameter.flag);
  EXPECT_EQ(found, expected);
}

std::string refusal(const FiniteVolumeOptions& options) {
  return tests::refusal([&] { validate(options); }, "");
}

TEST(Options, InvalidValuesAreRefusedByName) {
  EXPECT_EQ(refusal({}), "");
  EXPECT_EQ(refusal({.order = 9}), "fd order = 9 (must be between 2 and 8)");
  EXPECT_EQ(refusal({.nv = 31}),
            "fd nv = 31 (must be an even number from 16 to 2000: y' = 0 lies between two cells)");
  EXPECT_NE(refusal({.impact = ImpactCondition::exact}), "");
  EXPECT_NE(refusal({.refinement = 0}), "");
  EXPECT_NE(refusal({.origin_refinement = 0.5}), "");
  EXPECT_NE(refusal({.nx = 3}), "");
  EXPECT_NE(refusal({.x1_max = -1.0}), "");
  EXPECT_NE(refusal({.x2_max = 0.0}), "");
  EXPECT_NE(refusal({.wall_density = 1}), "");
  EXPECT_NE(refusal({.accuracy = 0}), "");
  EXPECT_NE(refusal({.max_seconds = 0}), "");
  EXPECT_NE(refusal({.tolerance = 1e-11}), "");
  EXPECT_NE(refusal({.residual_tolerance = 0}), "");
}

TEST(Options, ContradictoryOptionsAreRefused) {
  EXPECT_EQ(
      refusal({.regularisation_length = 0.3}),
      "regularisation length with equation kf: only km4 has this length; leave out the length");
  EXPECT_EQ(refusal({.equation = DensityEquation::km4, .regularisation_length = 0.0}), "");
  EXPECT_NE(refusal({.equation = DensityEquation::km4, .regularisation_length = -0.3}), "");
  EXPECT_NE(refusal({.nx = 40, .tolerance = 1e-4}), "");
}

TEST(Options, AnIdDeterminesEquationAndImpact) {
  for (const auto* wanted : {"fd-white", "fd-km4", "fd-km4-pade", "fd-kf", "fd-white-delta",
                             "fd-km4-delta", "fd-km4-pade-delta", "fd-kf-delta"}) {
    const auto options = options_of(wanted);
    ASSERT_TRUE(options) << wanted;
    EXPECT_EQ(solution_id(*options), wanted);
  }
  EXPECT_EQ(options_of("fd-km4-delta")->equation, DensityEquation::km4);
  EXPECT_EQ(options_of("fd-km4-delta")->impact, ImpactCondition::delta);
  for (const auto* unknown : {"fd", "fd-", "kf", "fd-kf-exact", "fd-kf-map", "epc-gaussian-n4"}) {
    EXPECT_FALSE(options_of(unknown)) << unknown;
  }
}

TEST(Options, DetermineTheIdentityOfTheSolution) {
  const auto identity = fd_fpk::solution_identity(
      {.equation = DensityEquation::km4, .impact = ImpactCondition::delta});
  EXPECT_EQ(identity.id, "fd-km4-delta");
  EXPECT_EQ(identity.method, "fd");
  EXPECT_EQ(identity.equation, DensityEquation::km4);
  EXPECT_EQ(identity.impact, ImpactCondition::delta);
  EXPECT_EQ(identity.role, transform::SolutionRole::equation);
}

TEST(TransientOptions, RoundTripThroughTheirValues) {
  const auto& description = transient_option_descriptions();
  const auto defaults = description.values({});
  const auto values = description.values({.until = 7,
                                          .snapshots = 11,
                                          .start_displacement = 0.3,
                                          .start_velocity = 0.4,
                                          .start_mean_displacement = -0.2,
                                          .start_mean_velocity = 0.1,
                                          .relative_tolerance = 1e-4,
                                          .max_order = 3,
                                          .periodic = true});
  EXPECT_EQ(description.values(description.read(values, "options")), values);
  for (std::size_t k = 0; k < values.size(); ++k)
    EXPECT_NE(values[k], defaults[k]) << values[k].name;
}

TEST(TransientOptions, HaveTheFlagsOfTheCommandLine) {
  std::vector<std::string> flags;
  for (const auto& parameter : transient_option_descriptions().parameters())
    flags.push_back(parameter.flag);
  EXPECT_EQ(flags,
            (std::vector<std::string>{"until", "snapshots", "periodic", "start-y", "start-v",
                                      "start-mean-y", "start-mean-v", "time-tolerance", ""}));
}

TEST(TransientOptions, InvalidValuesAreRefused) {
  const auto refused = [](const TransientOptions& transient,
                          const FiniteVolumeOptions& options = {}) {
    EXPECT_THROW(validate(options, transient), InputError);
  };
  EXPECT_NO_THROW(validate({}, {.until = 1}));
  refused({});
  refused({.until = -1});
  refused({.until = HUGE_VAL});
  refused({.until = 1, .snapshots = 0});
  refused({.until = 1, .start_displacement = 0.0});
  refused({.until = 1, .start_velocity = -1.0});
  refused({.until = 1, .start_mean_displacement = HUGE_VAL});
  refused({.until = 1, .relative_tolerance = 0});
  refused({.until = 1, .max_order = 6});
  refused({.until = 1}, {.tolerance = 1e-4});
  refused({.until = 1}, {.transport = TransportScheme::characteristics});
  refused({.until = 1}, {.refinement = -1});
  for (const int order : {2, 4, 6, 7, 8}) refused({.until = 1}, {.order = order});
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
