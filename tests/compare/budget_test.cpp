#include "compare/error_budget.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/input_error.hpp"
#include "compare/comparison.hpp"
#include "made_up_solutions.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::compare {
namespace {

using problem::DensityEquation;
using problem::ImpactCondition;
using transform::Solution;
using transform::StateVariable;
using transform::Status;

constexpr std::size_t kOuterBins = 20;  // of y; of y' as many on either side
constexpr double kPlateau = 1e-4;       // within the tail

// Probability in the outer bins for exponent 0.
double plateau_mass(const std::vector<double>& edges, StateVariable variable) {
  const double sides = variable == StateVariable::y ? 1 : 2;
  return sides * kOuterBins * (edges[1] - edges[0]) * kPlateau;
}

/// A marginal that alternates by +-amplitude about a uniform density on the inner bins and equals
/// 1e-4 * 10^exponent on the outer bins. Its mass is 1 for exponent 0.
transform::Marginal alternating(const std::vector<double>& edges, StateVariable variable,
                                double amplitude, double exponent) {
  transform::Marginal m{edges, {}, {}, {}};
  const std::size_t bins = edges.size() - 1;
  const std::size_t below = variable == StateVariable::ydot ? kOuterBins : 0;
  const std::size_t inner = bins - below - kOuterBins;
  for (std::size_t k = 0; k < bins; ++k) {
    const double uniform =
        (1 - plateau_mass(edges, variable)) / (static_cast<double>(inner) * m.bin_width(k));
    const bool outside = k < below || k >= below + inner;
    m.density.push_back(outside ? kPlateau * std::pow(10, exponent)
                                : uniform * (1 + (k % 2 == 0 ? amplitude : -amplitude)));
  }
  return m;
}

/// Amplitude and exponent for y; twice these values for y'.
struct Height {
  double amplitude;
  double exponent = 0;
};

transform::Marginal marginal_of(const ComparisonBins& axes, StateVariable variable, Height height) {
  const double factor = variable == StateVariable::y ? 1 : 2;
  return alternating(comparison_bin_edges(axes, variable), variable, factor * height.amplitude,
                     factor * height.exponent);
}

transform::GridDensity product(const ComparisonBins& axes, double amplitude) {
  const auto y = marginal_of(axes, StateVariable::y, {amplitude});
  const auto v = marginal_of(axes, StateVariable::ydot, {amplitude});
  transform::GridDensity density{axes.y_edges, axes.v_edges, {}};
  for (const double p : y.density) {
    for (const double q : v.density) density.averages.push_back(p * q);
  }
  return density;
}

Solution made(const ComparisonBins& axes, const std::string& id, DensityEquation equation,
              ImpactCondition impact, Height height) {
  Solution s{.identity = tests::identity(id, id.substr(0, id.find('-')), equation, impact)};
  s.status = Status::ok;
  for (const auto variable : {StateVariable::y, StateVariable::ydot}) {
    s.estimated_marginals.emplace_back(variable, marginal_of(axes, variable, height));
  }
  return s;
}

/// A solution with two grids; its Richardson limit is fine + (fine - coarser) / 3.
Solution with_grids(const ComparisonBins& axes, const std::string& id, DensityEquation equation,
                    double fine, double coarser) {
  Solution s = made(axes, id, equation, ImpactCondition::map, {fine});
  s.density = product(axes, fine);
  s.extrapolation = {product(axes, coarser), 1.0 / 3};
  return s;
}

/// A chain of models with known distances: amplitudes 0.1, 0.03, 0.02, 0.011 (limit 0.01), 0.
std::vector<Solution> chain_of_models(const ComparisonBins& axes) {
  std::vector<Solution> solutions{
      made(axes, "epc-gaussian-n6", DensityEquation::km4, ImpactCondition::delta, {0.1, 0.5}),
      made(axes, "fd-km4-delta", DensityEquation::km4, ImpactCondition::delta, {0.03, 0.2}),
      with_grids(axes, "fd-km4", DensityEquation::km4, 0.02, 0.026),
      with_grids(axes, "fd-kf", DensityEquation::kf, 0.011, 0.014),
      made(axes, "mcs", DensityEquation::kf, ImpactCondition::exact, {0, 0.03}),
  };
  solutions.back().sampling = {.y = 0.012, .ydot = 0.013, .y_99 = 0.02, .ydot_99 = 0.021};
  return solutions;
}

std::vector<ErrorBudgetRow> budget_of(const std::vector<Solution>& solutions) {
  return compare_solutions(comparison_bins(tests::paper_case(1)), solutions).budget;
}

std::vector<Solution> chain_of_models() {
  return chain_of_models(comparison_bins(tests::paper_case(1)));
}

std::vector<std::string> names(const ErrorBudgetRow& row) {
  std::vector<std::string> result;
  for (const auto& part : row.parts) result.push_back(part.error_budget_part_name());
  return result;
}

using Names = std::vector<std::string>;

void expect_the_parts_bound_the_total(const std::vector<ErrorBudgetRow>& budget) {
  constexpr double kRounding = 1e-12;
  for (const auto& row : budget) {
    double l1 = 0, tail = 0;
    for (const auto& part : row.parts) {
      l1 += part.l1;
      tail += part.tail;
    }
    EXPECT_LE(row.total, l1 * (1 + kRounding)) << row.solution;
    ASSERT_GT(row.tail_bins, 0) << row.solution;
    EXPECT_LE(row.total_tail, tail * (1 + kRounding)) << row.solution;
    EXPECT_GT(row.total, 0) << row.solution;
  }
}

std::vector<Solution> without(std::vector<Solution> solutions, const std::string& id) {
  std::erase_if(solutions, [&](const Solution& solution) { return solution.id() == id; });
  return solutions;
}

TEST(Budget, PartsAreDistancesOfConsecutiveModels) {
  const auto axes = comparison_bins(tests::paper_case(1));
  const auto budget = budget_of(chain_of_models(axes));
  ASSERT_EQ(budget.size(), 2u);
  for (const auto& row : budget) {
    const double f = row.variable == StateVariable::y ? 1 : 2;
    EXPECT_EQ(row.reference, "mcs");
    EXPECT_EQ(names(row), (Names{"closure", "impact", "truncation", "discretisation", "sampling"}));
    // The closure, fd-km4-delta, fd-km4, fd-kf, its limit (0.011 - 0.003/3) and mcs.
    const double amplitudes[] = {0.1, 0.03, 0.02, 0.011, 0.01, 0};
    const double exponents[] = {0.5, 0.2, 0, 0, 0, 0.03};
    const Names ids{"epc-gaussian-n6", "fd-km4-delta", "fd-km4", "fd-kf", "fd-kf limit", "mcs"};
    const double outer = plateau_mass(comparison_bin_edges(axes, row.variable), row.variable);
    const auto l1 = [&](std::size_t i, std::size_t j) {
      return f * std::abs(amplitudes[i] - amplitudes[j]) * (1 - outer) +
             outer * std::abs(std::pow(10, f * exponents[i]) - std::pow(10, f * exponents[j]));
    };
    EXPECT_NEAR(row.total, l1(0, 5), 1e-12);
    for (std::size_t k = 0; k < row.parts.size(); ++k) {
      const auto& part = row.parts[k];
      EXPECT_NEAR(part.l1, l1(k, k + 1), 1e-12) << part.error_budget_part_name();
      EXPECT_NEAR(part.tail, f * std::abs(exponents[k] - exponents[k + 1]), 1e-12)
          << part.error_budget_part_name();
      EXPECT_EQ(part.from, ids[k]);
      EXPECT_EQ(part.to, ids[k + 1]);
    }
    EXPECT_EQ(row.tail_bins, row.variable == StateVariable::y ? 20 : 40);
    EXPECT_NEAR(row.total_tail, f * 0.47, 1e-9);
  }
  expect_the_parts_bound_the_total(budget);
}

TEST(Budget, PartsHaveTheDiscretisationErrorsOfTheirEndsAsUncertainty) {
  const auto budget = budget_of(chain_of_models());
  const auto& parts = budget[1].parts;  // y': twice the amplitudes
  const double inner =
      1 - plateau_mass(comparison_bins(tests::paper_case(1)).v_edges, StateVariable::ydot);
  EXPECT_FALSE(parts[0].uncertainty);  // fd-km4-delta has no error estimate
  EXPECT_FALSE(parts[1].uncertainty);
  EXPECT_NEAR(parts[2].uncertainty.value(), 2 * inner * (0.002 + 0.001), 1e-12);
  EXPECT_NEAR(parts[3].uncertainty.value(), 2 * inner * 0.001, 1e-12);
  EXPECT_FALSE(parts[4].uncertainty);
  EXPECT_EQ(parts[4].expected, 0.013);
  EXPECT_EQ(parts[4].quantile_99, 0.021);
}

TEST(Budget, LinksAreJoinedIfASolutionIsMissingOrNotOk) {
  auto solutions = chain_of_models();
  const auto parts_of = [](const std::vector<Solution>& some) {
    const auto budget = budget_of(some);
    return budget.empty() ? Names{} : names(budget.front());
  };
  EXPECT_EQ(parts_of(without(solutions, "fd-km4-delta")),
            (Names{"closure + impact", "truncation", "discretisation", "sampling"}));
  EXPECT_EQ(parts_of(without(solutions, "mcs")),
            (Names{"closure", "impact", "truncation", "discretisation"}));
  EXPECT_EQ(parts_of(without(solutions, "fd-kf")),
            (Names{"closure", "impact", "truncation + discretisation + sampling"}));
  EXPECT_EQ(parts_of(without(without(solutions, "fd-kf"), "mcs")), Names{});  // no reference
  // A single part would equal the total.
  EXPECT_EQ(parts_of({solutions.front(), solutions.back()}), Names{});
  EXPECT_EQ(parts_of({solutions.front()}), Names{});

  auto no_limit = solutions;
  no_limit[3].extrapolation.reset();
  EXPECT_EQ(parts_of(no_limit),
            (Names{"closure", "impact", "truncation", "discretisation + sampling"}));
  EXPECT_EQ(parts_of(without(no_limit, "mcs")), (Names{"closure", "impact", "truncation"}));

  solutions[2].status = Status::ill_posed;
  EXPECT_EQ(parts_of(solutions),
            (Names{"closure", "impact + truncation", "discretisation", "sampling"}));
  solutions[0].status = Status::inadmissible;  // the status of a closure has no influence
  EXPECT_EQ(parts_of(solutions).size(), 4u);
}

TEST(Budget, ChainDependsOnTheEquationOfTheClosure) {
  const auto axes = comparison_bins(tests::paper_case(1));
  auto solutions = chain_of_models(axes);
  solutions.insert(
      solutions.begin(),
      {made(axes, "epc-moment-n4", DensityEquation::kf, ImpactCondition::map, {0.05}),
       made(axes, "epc-moment-white-n4", DensityEquation::white, ImpactCondition::map, {0.3}),
       made(axes, "epc-gaussian-kf-n4", DensityEquation::kf, ImpactCondition::delta, {0.04}),
       made(axes, "fd-white", DensityEquation::white, ImpactCondition::map, {0.25})});
  const auto budget = budget_of(solutions);
  EXPECT_EQ(names(budget[0]), (Names{"closure", "discretisation", "sampling"}));
  EXPECT_EQ(names(budget[2]), (Names{"closure", "white noise", "discretisation", "sampling"}));
  EXPECT_NEAR(budget[2].parts[1].l1, 0.25 - 0.011, 1e-4);
  EXPECT_EQ(names(budget[4]), (Names{"closure + impact", "discretisation", "sampling"}));
}

TEST(Budget, TheTailUsesTheSameBinsForEveryPart) {
  auto solutions = chain_of_models();
  auto& delta = solutions[1].estimated_marginals[0].second;
  delta.density.back() = -1e-9;
  auto& simulated = solutions.back().estimated_marginals[0].second;
  for (const double p : simulated.density) {
    simulated.lower.push_back(0.9 * p);
    simulated.upper.push_back(1.1 * p);
  }
  const auto last = simulated.size() - 2;
  simulated.upper[last] = 2.2 * simulated.density[last];  // interval too wide
  const auto budget = budget_of(solutions);
  EXPECT_EQ(budget[0].tail_bins, 18);
  EXPECT_NEAR(budget[0].total_tail, 0.47, 1e-9);
  EXPECT_EQ(budget[1].tail_bins, 40);

  for (double& p : delta.density) p = std::abs(p) * 0;
  const auto none = budget_of(solutions);
  EXPECT_EQ(none[0].tail_bins, 0);
  EXPECT_TRUE(std::isnan(none[0].total_tail));
  EXPECT_TRUE(std::isnan(none[0].parts[0].tail));
}

TEST(Budget, NamesOfJoinedLinksAreParsed) {
  const std::vector<ModelApproximation> approximations{
      ModelApproximation::closure, ModelApproximation::white_noise, ModelApproximation::sampling};
  EXPECT_EQ(name(approximations), "closure + white noise + sampling");
  EXPECT_EQ(parse_approximations(name(approximations)), approximations);
  EXPECT_THROW(parse_approximations("closure + magic"), InputError);
  EXPECT_THROW(parse_approximations(""), InputError);
}

TEST(Budget, ClosuresAreListedOnceWithTheirRowsAndPartsInTheOrderOfTheChain) {
  const auto solutions = chain_of_models();
  auto budget = budget_of(solutions);
  budget.push_back(budget[0]);
  budget.back().solution = "another";
  budget.back().parts = {
      {.approximations = {ModelApproximation::closure, ModelApproximation::impact},
       .from = "",
       .to = "",
       .l1 = 1,
       .tail = 1},
      {.approximations = {ModelApproximation::sampling}, .from = "", .to = "", .l1 = 1, .tail = 1}};
  const auto closures = group_budget_by_closure(budget, solutions);
  ASSERT_EQ(closures.size(), 2u);
  EXPECT_EQ(closures[0].existing_budget_rows().size(), 2u);
  EXPECT_EQ(closures[1].budget_row_of(StateVariable::ydot), nullptr);
  EXPECT_EQ(budget_part_names(closures), (Names{"closure", "impact", "truncation", "discretisation",
                                                "closure + impact", "sampling"}));
  EXPECT_TRUE(budget[0].find_budget_part("sampling")->is_reference_error());
  EXPECT_FALSE(budget[0].find_budget_part("truncation")->is_reference_error());
  EXPECT_EQ(budget[0].find_budget_part("magic"), nullptr);
}

TEST(Budget, ThePartsBoundTheTotalWhateverTheOrderOfTheModels) {
  const auto axes = comparison_bins(tests::paper_case(1));
  auto solutions = chain_of_models(axes);
  solutions[0] =
      made(axes, "epc-gaussian-n6", DensityEquation::km4, ImpactCondition::delta, {0.01, 0.01});
  solutions[1] =
      made(axes, "fd-km4-delta", DensityEquation::km4, ImpactCondition::delta, {0.2, -0.3});
  const auto budget = budget_of(solutions);
  expect_the_parts_bound_the_total(budget);
  EXPECT_LT(budget[0].total, 0.1 * budget[0].parts[0].l1);
  expect_the_parts_bound_the_total(tests::made_up_case().budget);
}

}  // namespace
}  // namespace fpkcheck::compare
