#include "compare/budget/budget.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "compare/budget/chain.hpp"
#include "compare/methods.hpp"
#include "compare/run_cases.hpp"
#include "compare/summary.hpp"
#include "made_up_solutions.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::compare {
namespace {

using problem::Impact;
using transform::Status;
using transform::Variable;
using Json = nlohmann::ordered_json;

constexpr std::size_t kOuterBins = 20;  // of y; of y' as many on either side
constexpr double kPlateau = 1e-4;       // within the tail

// Probability in the outer bins at exponent 0.
double plateau_mass(const std::vector<double>& edges, Variable variable) {
  const double sides = variable == Variable::y ? 1 : 2;
  return sides * kOuterBins * (edges[1] - edges[0]) * kPlateau;
}

/// A marginal that alternates by +-amplitude around a uniform density on the inner bins; the outer
/// ones hold 1e-4 * 10^exponent. Its mass is 1 at exponent 0.
transform::Marginal alternating(const std::vector<double>& edges, Variable variable,
                                double amplitude, double exponent) {
  transform::Marginal m{edges, {}, {}, {}};
  const std::size_t bins = edges.size() - 1;
  const std::size_t below = variable == Variable::ydot ? kOuterBins : 0;
  const std::size_t inner = bins - below - kOuterBins;
  for (std::size_t k = 0; k < bins; ++k) {
    const double uniform =
        (1 - plateau_mass(edges, variable)) / (static_cast<double>(inner) * m.width(k));
    const bool outside = k < below || k >= below + inner;
    m.density.push_back(outside ? kPlateau * std::pow(10, exponent)
                                : uniform * (1 + (k % 2 == 0 ? amplitude : -amplitude)));
  }
  return m;
}

/// Amplitude and exponent; both are twice as large in y'.
struct Height {
  double amplitude;
  double exponent = 0;
};

transform::Marginal marginal_of(const ComparisonAxes& axes, Variable variable, Height height) {
  const double factor = variable == Variable::y ? 1 : 2;
  return alternating(edges(axes, variable), variable, factor * height.amplitude,
                     factor * height.exponent);
}

transform::GridDensity product(const ComparisonAxes& axes, double amplitude) {
  const auto y = marginal_of(axes, Variable::y, {amplitude});
  const auto v = marginal_of(axes, Variable::ydot, {amplitude});
  transform::GridDensity density{axes.y_edges, axes.v_edges, {}};
  for (const double p : y.density) {
    for (const double q : v.density) density.averages.push_back(p * q);
  }
  return density;
}

Entry made(const ComparisonAxes& axes, const std::string& id, const std::string& equation,
           Impact impact, Height height) {
  transform::Solution s;
  s.id = id;
  s.method = id.substr(0, id.find('-'));
  s.equation = equation;
  s.impact = impact;
  s.status = Status::ok;
  for (const auto variable : {Variable::y, Variable::ydot}) {
    s.estimated_marginals.emplace_back(variable, marginal_of(axes, variable, height));
  }
  return {s, Json::object(), Json::object()};
}

/// Its grids tend to fine + (fine - coarser) / 3.
Entry with_grids(const ComparisonAxes& axes, const std::string& id, const std::string& equation,
                 double fine, double coarser) {
  Entry entry = made(axes, id, equation, Impact::map, {fine});
  entry.solution.density = product(axes, fine);
  entry.solution.extrapolation = {product(axes, coarser), 1.0 / 3};
  return entry;
}

/// A chain of models whose distances are known: amplitudes 0.1, 0.03, 0.02, 0.011 (limit 0.01), 0.
std::vector<Entry> chain_of_models(const ComparisonAxes& axes) {
  std::vector<Entry> entries{
      made(axes, "epc-gaussian-n6", "km4", Impact::delta, {0.1, 0.5}),
      made(axes, "fd-km4-delta", "km4", Impact::delta, {0.03, 0.2}),
      with_grids(axes, "fd-km4", "km4", 0.02, 0.026),
      with_grids(axes, "fd-kf", "kf", 0.011, 0.014),
      made(axes, "mcs", "kf", Impact::exact, {0, 0.03}),
  };
  entries.back().details["sampling_l1"] = {
      {"y", 0.012}, {"ydot", 0.013}, {"y_99", 0.02}, {"ydot_99", 0.021}};
  return entries;
}

CaseReport report_of(std::vector<Entry> entries) {
  const auto problem = tests::paper_case(1);
  return report_on_case(problem, comparison_axes(problem), std::move(entries));
}

std::vector<Entry> chain_of_models() {
  return chain_of_models(comparison_axes(tests::paper_case(1)));
}

std::vector<std::string> names(const BudgetRow& row) {
  std::vector<std::string> result;
  for (const auto& part : row.parts) result.push_back(part.name);
  return result;
}

using Names = std::vector<std::string>;

void expect_the_parts_bound_the_total(const std::vector<BudgetRow>& budget) {
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

std::vector<Entry> without(std::vector<Entry> entries, const std::string& id) {
  std::erase_if(entries, [&](const Entry& entry) { return entry.solution.id == id; });
  return entries;
}

TEST(Budget, EachPartIsTheDistanceOfTwoNeighboursInTheChain) {
  const auto axes = comparison_axes(tests::paper_case(1));
  const auto budget = error_budget(report_of(chain_of_models(axes)));
  ASSERT_EQ(budget.size(), 2u);
  for (const auto& row : budget) {
    const double f = row.variable == Variable::y ? 1 : 2;
    EXPECT_EQ(row.reference, "mcs");
    EXPECT_EQ(names(row), (Names{"closure", "impact", "truncation", "discretisation", "sampling"}));
    // Of the closure, fd-km4-delta, fd-km4, fd-kf, its limit (0.011 - 0.003/3) and mcs.
    const double amplitudes[] = {0.1, 0.03, 0.02, 0.011, 0.01, 0};
    const double exponents[] = {0.5, 0.2, 0, 0, 0, 0.03};
    const Names ids{"epc-gaussian-n6", "fd-km4-delta", "fd-km4", "fd-kf", "fd-kf limit", "mcs"};
    const double outer = plateau_mass(edges(axes, row.variable), row.variable);
    const auto l1 = [&](std::size_t i, std::size_t j) {
      return f * std::abs(amplitudes[i] - amplitudes[j]) * (1 - outer) +
             outer * std::abs(std::pow(10, f * exponents[i]) - std::pow(10, f * exponents[j]));
    };
    EXPECT_NEAR(row.total, l1(0, 5), 1e-12);
    for (std::size_t k = 0; k < row.parts.size(); ++k) {
      const auto& part = row.parts[k];
      EXPECT_NEAR(part.l1, l1(k, k + 1), 1e-12) << part.name;
      EXPECT_NEAR(part.tail, f * std::abs(exponents[k] - exponents[k + 1]), 1e-12) << part.name;
      EXPECT_EQ(part.from, ids[k]);
      EXPECT_EQ(part.to, ids[k + 1]);
    }
    EXPECT_EQ(row.tail_bins, row.variable == Variable::y ? 20 : 40);
    EXPECT_NEAR(row.total_tail, f * 0.47, 1e-9);
  }
  expect_the_parts_bound_the_total(budget);
}

TEST(Budget, PartsAreKnownToTheDiscretisationErrorsOfTheirEnds) {
  const auto budget = error_budget(report_of(chain_of_models()));
  const auto& parts = budget[1].parts;  // y': all twice
  const double inner =
      1 - plateau_mass(comparison_axes(tests::paper_case(1)).v_edges, Variable::ydot);
  EXPECT_FALSE(parts[0].uncertainty);  // fd-km4-delta does not know its error
  EXPECT_FALSE(parts[1].uncertainty);
  EXPECT_NEAR(parts[2].uncertainty.value(), 2 * inner * (0.002 + 0.001), 1e-12);
  EXPECT_NEAR(parts[3].uncertainty.value(), 2 * inner * 0.001, 1e-12);
  EXPECT_FALSE(parts[4].uncertainty);
  EXPECT_EQ(parts[4].expected, 0.013);
  EXPECT_EQ(parts[4].in_99, 0.021);
}

TEST(Budget, LinksJoinWhereASolutionIsMissingOrNotOk) {
  auto entries = chain_of_models();
  const auto parts_of = [](std::vector<Entry> some) {
    const auto budget = error_budget(report_of(std::move(some)));
    return budget.empty() ? Names{} : names(budget.front());
  };
  EXPECT_EQ(parts_of(without(entries, "fd-km4-delta")),
            (Names{"closure + impact", "truncation", "discretisation", "sampling"}));
  EXPECT_EQ(parts_of(without(entries, "mcs")),
            (Names{"closure", "impact", "truncation", "discretisation"}));
  EXPECT_EQ(parts_of(without(entries, "fd-kf")),
            (Names{"closure", "impact", "truncation + discretisation + sampling"}));
  EXPECT_EQ(parts_of(without(without(entries, "fd-kf"), "mcs")), Names{});  // no reference
  EXPECT_EQ(parts_of({entries.front(), entries.back()}),
            (Names{"closure + impact + truncation + sampling"}));
  EXPECT_EQ(parts_of({entries.front()}), Names{});

  auto no_limit = entries;
  no_limit[3].solution.extrapolation.reset();
  EXPECT_EQ(parts_of(no_limit),
            (Names{"closure", "impact", "truncation", "discretisation + sampling"}));
  EXPECT_EQ(parts_of(without(no_limit, "mcs")), (Names{"closure", "impact", "truncation"}));

  entries[2].solution.status = Status::ill_posed;
  EXPECT_EQ(parts_of(entries),
            (Names{"closure", "impact + truncation", "discretisation", "sampling"}));
  entries[0].solution.status = Status::inadmissible;  // a closure counts whatever its status
  EXPECT_EQ(parts_of(entries).size(), 4u);
}

TEST(Budget, AClosureOfAnotherEquationHasAnotherChain) {
  const auto axes = comparison_axes(tests::paper_case(1));
  auto entries = chain_of_models(axes);
  entries.insert(entries.begin(), {made(axes, "epc-moment-n4", "kf", Impact::map, {0.05}),
                                   made(axes, "epc-moment-white-n4", "white", Impact::map, {0.3}),
                                   made(axes, "epc-gaussian-kf-n4", "kf", Impact::delta, {0.04}),
                                   made(axes, "fd-white", "white", Impact::map, {0.25})});
  const auto budget = error_budget(report_of(entries));
  EXPECT_EQ(names(budget[0]), (Names{"closure", "discretisation", "sampling"}));
  EXPECT_EQ(names(budget[2]), (Names{"closure", "white noise", "discretisation", "sampling"}));
  EXPECT_NEAR(budget[2].parts[1].l1, 0.25 - 0.011, 1e-4);
  EXPECT_EQ(names(budget[4]), (Names{"closure + impact", "discretisation", "sampling"}));
}

TEST(Budget, TheTailUsesTheSameBinsForEveryPart) {
  auto entries = chain_of_models();
  auto& delta = entries[1].solution.estimated_marginals[0].second;
  delta.density.back() = -1e-9;
  auto& simulated = entries.back().solution.estimated_marginals[0].second;
  for (const double p : simulated.density) {
    simulated.lower.push_back(0.9 * p);
    simulated.upper.push_back(1.1 * p);
  }
  const auto last = simulated.size() - 2;
  simulated.upper[last] = 2.2 * simulated.density[last];  // not known well
  const auto budget = error_budget(report_of(entries));
  EXPECT_EQ(budget[0].tail_bins, 18);
  EXPECT_NEAR(budget[0].total_tail, 0.47, 1e-9);
  EXPECT_EQ(budget[1].tail_bins, 40);

  for (double& p : delta.density) p = std::abs(p) * 0;
  const auto none = error_budget(report_of(entries));
  EXPECT_EQ(none[0].tail_bins, 0);
  EXPECT_TRUE(std::isnan(none[0].total_tail));
  const Json json = with_null_for_non_finite(to_json(none));
  EXPECT_TRUE(json[0]["total_tail"].is_null());
  EXPECT_TRUE(json[0]["parts"][0]["tail"].is_null());
}

TEST(Budget, HasTheShapeOfTheContract) {
  const Json json = to_json(error_budget(report_of(chain_of_models())));
  ASSERT_EQ(json.size(), 2u);
  const auto keys = [](const Json& object) {
    std::vector<std::string> result;
    for (const auto& [key, value] : object.items()) result.push_back(key);
    return result;
  };
  EXPECT_EQ(keys(json[0]),
            (Names{"solution", "variable", "reference", "total", "total_tail", "tail", "parts"}));
  EXPECT_EQ(json[1]["variable"], "ydot");
  EXPECT_EQ(json[0]["tail"].dump(), R"({"from":1e-05,"to":0.001,"bins":20})");
  EXPECT_EQ(keys(json[0]["parts"][0]), (Names{"name", "from", "to", "l1", "tail", "uncertainty"}));
  EXPECT_TRUE(json[0]["parts"][0]["uncertainty"].is_null());
  EXPECT_EQ(keys(json[0]["parts"][4]),
            (Names{"name", "from", "to", "l1", "tail", "expected", "in_99"}));
}

TEST(Budget, ThePartsBoundTheTotalWhateverTheOrderOfTheModels) {
  const auto axes = comparison_axes(tests::paper_case(1));
  auto entries = chain_of_models(axes);
  entries[0] = made(axes, "epc-gaussian-n6", "km4", Impact::delta, {0.01, 0.01});
  entries[1] = made(axes, "fd-km4-delta", "km4", Impact::delta, {0.2, -0.3});
  const auto budget = error_budget(report_of(entries));
  expect_the_parts_bound_the_total(budget);
  EXPECT_LT(budget[0].total, 0.1 * budget[0].parts[0].l1);
  expect_the_parts_bound_the_total(error_budget(tests::full_report()));
}

TEST(Budget, OfARealRunIsBoundedByItsPartsInEveryRow) {
  mcs::Options brief;
  brief.time = 200000;
  const auto reports = run_cases(
      {tests::paper_case(1)},
      select_methods("epc-gaussian-n2,epc-gaussian-n4,epc-gaussian-n6,epc-moment-n8,fd,mcs", brief),
      0, {});
  const auto budget = error_budget(reports.front());
  ASSERT_EQ(budget.size(), 8u);
  expect_the_parts_bound_the_total(budget);
  for (const auto& row : budget) {
    const bool moment = row.solution == "epc-moment-n8";
    EXPECT_EQ(row.parts.size(), moment ? 3u : 5u) << row.solution;
    for (const auto& part : row.parts) {
      if (part.name == "sampling") {
        EXPECT_LT(part.l1, 1.5 * part.in_99.value());
      } else if (part.name != "discretisation") {
        EXPECT_GT(part.l1, part.uncertainty.value()) << row.solution << " " << part.name;
      }
    }
  }
  // docs/budget.md: what equivalent linearisation misses is the closure, not its equation.
  EXPECT_GT(budget[1].parts[0].l1, 20 * budget[1].parts[1].l1);
}

}  // namespace
}  // namespace fpkcheck::compare
