#include "epc/options.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "base/input_error.hpp"
#include "refusal.hpp"

namespace fpkcheck::epc {
namespace {

// Returns options that all differ from their defaults.
ClosureOptions non_default_options() {
  return {.order = 10,
          .formulation = Formulation::moment,
          .monomials = MonomialSet::general,
          .equation = DensityEquation::white,
          .tail = DensityTailTreatment::cut,
          .tolerance = 3.1e-9,
          .accuracy = 0.3,
          .max_iterations = 17,
          .max_seconds = 5};
}

// Returns all combinations of options that an id can express.
std::vector<ClosureOptions> named_options() {
  std::vector<ClosureOptions> list;
  for (const int order : {2, 12}) {
    for (const auto equation :
         {DensityEquation::white, DensityEquation::km4, DensityEquation::kf}) {
      list.push_back({.order = order, .equation = equation});
    }
    for (const auto equation : {DensityEquation::white, DensityEquation::kf}) {
      for (const auto tail : {DensityTailTreatment::confined, DensityTailTreatment::cut}) {
        list.push_back({.order = order,
                        .formulation = Formulation::moment,
                        .equation = equation,
                        .tail = tail});
      }
    }
    list.push_back({.order = order, .formulation = Formulation::polar});
  }
  return list;
}

std::string error_message(const ClosureOptions& options) {
  return tests::refusal([&] { validate(options); }, "");
}

TEST(ClosureOptions, SurviveARoundTripThroughTheirValues) {
  const auto values = solver_option_descriptions().values(non_default_options()),
             usual = solver_option_descriptions().values({});
  EXPECT_EQ(
      solver_option_descriptions().values(solver_option_descriptions().read(values, "options")),
      values);
  EXPECT_EQ(
      solver_option_descriptions().values(solver_option_descriptions().read(usual, "options")),
      usual);
  for (std::size_t k = 0; k < values.size(); ++k) EXPECT_NE(values[k], usual[k]) << values[k].name;
}

TEST(ClosureOptions, HaveTheNamesOfTheFiles) {
  std::vector<std::string> names;
  for (const auto& [name, value] : solver_option_descriptions().values({})) names.push_back(name);
  EXPECT_EQ(names,
            (std::vector<std::string>{"order", "formulation", "monomials", "equation", "tail",
                                      "tolerance", "accuracy", "max_seconds", "max_iterations"}));
}

TEST(ClosureOptions, OnTheCommandLineTheEquationIsOneThatAClosureMaySolve) {
  ClosureOptions options;
  const auto& equation = *solver_option_descriptions().find("equation");
  for (const char* word : {"white", "km4", "kf", "auto"}) {
    EXPECT_NO_THROW(solver_option_descriptions().parse(options, equation, word, "--equation"))
        << word;
  }
  EXPECT_FALSE(options.equation.has_value());
  EXPECT_THROW(solver_option_descriptions().parse(options, equation, "km4-pade", "--equation"),
               InputError);
}

TEST(ClosureOptions, AutomaticIsTheUsualEquationOfTheFormulation) {
  EXPECT_EQ(closure_density_equation({}), DensityEquation::km4);
  EXPECT_EQ(closure_density_equation({.formulation = Formulation::moment}), DensityEquation::kf);
  EXPECT_EQ(closure_density_equation({.formulation = Formulation::polar}), DensityEquation::kf);
  EXPECT_EQ(closure_density_equation({.equation = DensityEquation::white}), DensityEquation::white);
}

TEST(ClosureOptions, AreNamedByFormulationVariantAndOrder) {
  EXPECT_EQ(solution_id({}), "epc-gaussian-n6");
  EXPECT_EQ(solution_id({.order = 4, .equation = DensityEquation::white}), "epc-gaussian-white-n4");
  EXPECT_EQ(solution_id({.equation = DensityEquation::kf}), "epc-gaussian-kf-n6");
  EXPECT_EQ(solution_id({.equation = DensityEquation::km4}), "epc-gaussian-n6");
  EXPECT_EQ(
      solution_id(
          {.order = 8, .formulation = Formulation::moment, .tail = DensityTailTreatment::cut}),
      "epc-moment-cut-n8");
  EXPECT_EQ(
      solution_id(
          {.order = 4, .formulation = Formulation::moment, .equation = DensityEquation::white}),
      "epc-moment-white-n4");
  EXPECT_EQ(solution_id({.formulation = Formulation::moment, .equation = DensityEquation::kf}),
            "epc-moment-n6");
  EXPECT_EQ(solution_id({.formulation = Formulation::polar}), "epc-polar-n6");
}

TEST(ClosureOptions, SurviveARoundTripThroughTheirId) {
  std::set<std::string> ids;
  for (const ClosureOptions& options : named_options()) {
    EXPECT_EQ(error_message(options), "");
    ids.insert(solution_id(options));
    const auto again = options_of(solution_id(options));
    ASSERT_TRUE(again.has_value()) << solution_id(options);
    EXPECT_EQ(solution_id(*again), solution_id(options));
    EXPECT_EQ(again->formulation, options.formulation);
    EXPECT_EQ(again->tail, options.tail);
    EXPECT_EQ(closure_density_equation(*again), closure_density_equation(options));
    EXPECT_EQ(again->order, options.order);
    EXPECT_EQ(again->monomials, MonomialSet::point_symmetric);
  }
  EXPECT_EQ(ids.size(), named_options().size());
}

TEST(ClosureOptions, AnIdThatIsNoClosuresHasNone) {
  for (const char* other : {"", "epc", "epc-gaussian", "epc-gaussian-n", "epc-gaussian-nx",
                            "epc-gaussian-n6x", "epc-gaussian-km4-n6", "epc-moment-kf-n6",
                            "epc-polar-cut-n6", "epc-spherical-n6", "fd-kf-n6", "mcs"}) {
    EXPECT_FALSE(options_of(other).has_value()) << other;
  }
  EXPECT_EQ(options_of("epc-gaussian-n7")->order, 7);  // validate() refuses the order
}

TEST(ClosureOptions, IdentityStatesWhatIsSolved) {
  const auto gaussian = solution_identity({});
  EXPECT_EQ(gaussian.id, "epc-gaussian-n6");
  EXPECT_EQ(gaussian.method, "epc");
  EXPECT_EQ(gaussian.formulation, "gaussian");
  EXPECT_EQ(gaussian.order, 6);
  EXPECT_EQ(gaussian.equation, DensityEquation::km4);
  EXPECT_EQ(gaussian.impact, ImpactCondition::delta);
  EXPECT_EQ(gaussian.role, transform::SolutionRole::closure);
  const auto cut = solution_identity(non_default_options());
  EXPECT_EQ(cut.id, "epc-moment-cut-white-n10");
  EXPECT_EQ(cut.formulation, "moment-cut-white");
  EXPECT_EQ(cut.equation, DensityEquation::white);
  EXPECT_EQ(cut.impact, ImpactCondition::map);
}

TEST(ClosureOptions, HaveErrorsOfOneLine) {
  for (const int order : {-2, 0, 1, 3, 7, 14, 100}) {
    const std::string message = error_message({.order = order});
    EXPECT_NE(message.find("epc order = " + std::to_string(order) +
                           " (must be an even number from 2 to 12"),
              std::string::npos)
        << message;
    EXPECT_EQ(message.find('\n'), std::string::npos);
  }
  EXPECT_NE(error_message({.tolerance = 0}), "");
  EXPECT_NE(error_message({.accuracy = 0}), "");
  EXPECT_NE(error_message({.tolerance = std::nan("")}), "");
  EXPECT_NE(error_message({.max_iterations = 0}), "");
}

TEST(ClosureOptions, EveryEvenOrderUpToTheGreatestIsAllowed) {
  for (const auto& [formulation, name, meaning] : kFormulationNames) {
    for (int order = 2; order <= max_closure_order(formulation); order += 2) {
      EXPECT_EQ(error_message({.order = order, .formulation = formulation}), "") << name << order;
    }
    EXPECT_NE(
        error_message({.order = max_closure_order(formulation) + 2, .formulation = formulation}),
        "");
  }
}

TEST(ClosureOptions, WhatAFormulationCannotSolveIsRefused) {
  EXPECT_NE(error_message({.equation = DensityEquation::km4_pade}).find("epc equation = km4-pade"),
            std::string::npos);
  for (const auto equation : {DensityEquation::km4, DensityEquation::km4_pade}) {
    EXPECT_NE(error_message({.formulation = Formulation::moment, .equation = equation}), "");
  }
  for (const auto equation :
       {DensityEquation::white, DensityEquation::km4, DensityEquation::km4_pade}) {
    EXPECT_NE(error_message({.formulation = Formulation::polar, .equation = equation}), "");
  }
}

TEST(ClosureOptions, AChoiceThatAFormulationDoesNotHaveIsRefused) {
  for (const auto formulation : {Formulation::gaussian, Formulation::polar}) {
    EXPECT_NE(error_message({.formulation = formulation, .tail = DensityTailTreatment::cut})
                  .find("epc tail = cut"),
              std::string::npos);
  }
  for (const auto formulation : {Formulation::moment, Formulation::polar}) {
    EXPECT_NE(error_message({.formulation = formulation, .monomials = MonomialSet::general})
                  .find("epc monomials = general"),
              std::string::npos);
  }
  EXPECT_EQ(error_message({.formulation = Formulation::moment, .tail = DensityTailTreatment::cut}),
            "");
  EXPECT_EQ(error_message({.monomials = MonomialSet::general}), "");
}

}  // namespace
}  // namespace fpkcheck::epc
