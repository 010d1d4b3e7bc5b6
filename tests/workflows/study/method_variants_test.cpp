#include "workflows/study/method_variants.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "base/input_error.hpp"
#include "methods/builtin_solvers.hpp"
#include "toy_methods.hpp"

namespace fpkcheck::study {
namespace {

using problem::DensityEquation;
using problem::ImpactCondition;
using transform::SolutionRole;
using Names = std::vector<std::string>;

Names names(const methods::SolverRegistry& registry, SolutionRole role) {
  Names names;
  for (const auto& variant : method_variants(registry, role)) names.push_back(variant.name);
  return names;
}

Names ids_beside(const methods::SolverRegistry& registry, DensityEquation equation,
                 ImpactCondition impact) {
  Names ids;
  for (const auto& method : methods_compared_with_grids(registry, equation, impact, {}))
    ids.push_back(method.id());
  return ids;
}

TEST(Kinds, OfClosuresAreFormulationsAndTheirVariants) {
  EXPECT_EQ(names(methods::builtin_registry(), SolutionRole::closure),
            (Names{"gaussian", "gaussian-white", "gaussian-kf", "moment", "moment-white",
                   "moment-cut", "polar", "linearisation", "linearisation-delta", "averaging-white",
                   "averaging-kf", "cumulant", "cumulant-delta"}));
}

TEST(Kinds, IncludeExternallyRegisteredMethods) {
  // Names of the first solver's variants lack the solver's name.
  EXPECT_EQ(
      names(tests::toy_registry(), SolutionRole::closure),
      (Names{"flat", "flat-white", "other-flat", "other-flat-white", "plain", "plain-white"}));
}

TEST(Kinds, DistinguishDefaultsAndMethodsOfTheFullProblem) {
  for (const auto& variant : method_variants(methods::builtin_registry(), SolutionRole::closure)) {
    const std::set<std::string> defaults{"gaussian",      "moment",          "polar",
                                         "linearisation", "averaging-white", "averaging-kf",
                                         "cumulant"};
    const std::set<std::string> full{"moment", "moment-cut", "polar", "averaging-kf", "cumulant"};
    EXPECT_EQ(variant.is_default_variant, defaults.contains(variant.name)) << variant.name;
    EXPECT_EQ(variant.solves_full_problem(), full.contains(variant.name)) << variant.name;
  }
}

// Every closure approximates the full problem; for other equations only their own closures count.
TEST(OtherMethods, SolveTheEquationWithTheImpact) {
  const auto registry = methods::builtin_registry();
  EXPECT_EQ(ids_beside(registry, DensityEquation::kf, ImpactCondition::map),
            (Names{"epc-gaussian-n2", "epc-gaussian-n4",
                   "epc-gaussian-n6", "epc-moment-n2",
                   "epc-moment-n4",   "epc-moment-n6",
                   "epc-moment-n8",   "epc-moment-n10",
                   "epc-moment-n12",  "epc-polar-n2",
                   "epc-polar-n4",    "epc-polar-n6",
                   "epc-polar-n8",    "epc-polar-n10",
                   "epc-polar-n12",   "linearisation",
                   "averaging-white", "averaging-kf",
                   "cumulant-n2",     "cumulant-n4",
                   "cumulant-n6",     "mcs"}));
  EXPECT_EQ(ids_beside(registry, DensityEquation::km4, ImpactCondition::delta),
            (Names{"epc-gaussian-n2", "epc-gaussian-n4", "epc-gaussian-n6"}));
  EXPECT_EQ(ids_beside(registry, DensityEquation::white, ImpactCondition::map),
            (Names{"epc-moment-white-n2", "epc-moment-white-n4", "epc-moment-white-n6",
                   "epc-moment-white-n8", "epc-moment-white-n10", "epc-moment-white-n12",
                   "linearisation", "averaging-white", "mcs-white"}));
  EXPECT_EQ(ids_beside(registry, DensityEquation::white, ImpactCondition::delta),
            (Names{"epc-gaussian-white-n2", "epc-gaussian-white-n4", "epc-gaussian-white-n6",
                   "linearisation-delta"}));
  EXPECT_EQ(ids_beside(registry, DensityEquation::kf, ImpactCondition::delta),
            (Names{"epc-gaussian-kf-n2", "epc-gaussian-kf-n4", "epc-gaussian-kf-n6",
                   "cumulant-delta-n2", "cumulant-delta-n4", "cumulant-delta-n6"}));
  EXPECT_EQ(ids_beside(registry, DensityEquation::km4, ImpactCondition::map), Names{});
  EXPECT_EQ(ids_beside(registry, DensityEquation::km4_pade, ImpactCondition::map), Names{});
}

TEST(OtherMethods, HaveTheOrdersOfTheFamily) {
  const auto registry = tests::toy_registry();
  EXPECT_EQ(ids_beside(registry, DensityEquation::kf, ImpactCondition::map),
            (Names{"toy-flat-n2", "toy-flat-n4", "toy-flat-n6", "other-flat-n2", "other-flat-n4",
                   "other-flat-n6", "plain", "dice"}));
  EXPECT_EQ(ids_beside(registry, DensityEquation::white, ImpactCondition::map),
            (Names{"toy-flat-white-n2", "toy-flat-white-n4", "toy-flat-white-n6", "plain-white",
                   "dice-white"}));
}

TEST(OtherMethods, TheSimulationHasTheGivenOptions) {
  const auto methods = methods_compared_with_grids(
      methods::builtin_registry(), DensityEquation::white, ImpactCondition::map, {{"time", 3e3}});
  const auto& options = methods.back().options;
  EXPECT_NE(std::ranges::find(options, base::NamedParameterValue{"time", 3e3}), options.end());
  EXPECT_THROW(methods_compared_with_grids(methods::builtin_registry(), DensityEquation::white,
                                           ImpactCondition::map, {{"time", -1.0}}),
               InputError);
}

}  // namespace
}  // namespace fpkcheck::study
