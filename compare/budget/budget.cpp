#include "compare/budget/budget.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "compare/budget/chain.hpp"
#include "compare/distances.hpp"
#include "compare/summary_view.hpp"

namespace fpkcheck::compare {
namespace {

using Json = nlohmann::ordered_json;
using transform::Marginal;
using transform::Variable;

// Two decades below the densities that L1 sees; a simulation of the default length knows them to
// better than +-40 %.
constexpr double kTailFrom = 1e-5, kTailTo = 1e-3;

std::vector<std::size_t> tail_bins(const std::vector<ChainNode>& chain) {
  const Marginal& reference = chain.back().marginal;
  std::vector<std::size_t> bins;
  for (std::size_t k = 0; k < reference.size(); ++k) {
    if (reference.density[k] < kTailFrom || reference.density[k] >= kTailTo) continue;
    if (std::ranges::all_of(chain, [k](const ChainNode& node) {
          return node.marginal.density[k] > 0 && known_well(node.marginal, k);
        })) {
      bins.push_back(k);
    }
  }
  return bins;
}

double tail_distance(const Marginal& a, const Marginal& b, const std::vector<std::size_t>& bins) {
  if (bins.empty()) return std::numeric_limits<double>::quiet_NaN();
  double sum = 0;
  for (const auto k : bins) sum += std::abs(std::log10(a.density[k]) - std::log10(b.density[k]));
  return sum / static_cast<double>(bins.size());
}

// What the simulation says of its own L1 error.
void add_sampling_error(const CaseReport& report, Variable variable, BudgetPart& part) {
  const auto simulation = std::ranges::find_if(
      report.entries, [&](const Entry& entry) { return entry.solution.id == part.to; });
  if (!simulation->details.contains("sampling_l1")) return;
  const Json& sampling = simulation->details.at("sampling_l1");
  const std::string key(transform::name(variable));
  part.expected = number(sampling, key);
  part.in_99 = number(sampling, key + "_99");
}

BudgetPart part_between(const CaseReport& report, Variable variable, const ChainNode& from,
                        const ChainNode& to, const std::vector<std::size_t>& bins) {
  BudgetPart part{.name = to.link,
                  .from = from.id,
                  .to = to.id,
                  .l1 = distances(from.marginal, to.marginal).l1,
                  .tail = tail_distance(from.marginal, to.marginal, bins)};
  if (from.discretisation_error && to.discretisation_error) {
    part.uncertainty = *from.discretisation_error + *to.discretisation_error;
  }
  if (to.id == "mcs") add_sampling_error(report, variable, part);
  return part;
}

BudgetRow row_of(const CaseReport& report, const Entry& closure, Variable variable,
                 const std::vector<ChainNode>& chain) {
  const auto bins = tail_bins(chain);
  const ChainNode &first = chain.front(), &last = chain.back();
  BudgetRow row{.solution = closure.solution.id,
                .variable = variable,
                .reference = last.id,
                .total = distances(first.marginal, last.marginal).l1,
                .total_tail = tail_distance(first.marginal, last.marginal, bins),
                .tail_from = kTailFrom,
                .tail_to = kTailTo,
                .tail_bins = static_cast<int>(bins.size()),
                .parts = {}};
  for (std::size_t k = 1; k < chain.size(); ++k) {
    row.parts.push_back(part_between(report, variable, chain[k - 1], chain[k], bins));
  }
  return row;
}

Json to_json(const BudgetPart& part) {
  Json json{{"name", part.name},
            {"from", part.from},
            {"to", part.to},
            {"l1", part.l1},
            {"tail", part.tail}};
  if (part.expected) {
    json["expected"] = *part.expected;
    json["in_99"] = part.in_99 ? Json(*part.in_99) : Json();
  } else {
    json["uncertainty"] = part.uncertainty ? Json(*part.uncertainty) : Json();
  }
  return json;
}

}  // namespace

std::vector<BudgetRow> error_budget(const CaseReport& report) {
  std::vector<BudgetRow> budget;
  for (const auto& entry : report.entries) {
    if (entry.solution.method != "epc") continue;
    for (const auto variable : {Variable::y, Variable::ydot}) {
      const auto chain = budget_chain(report, entry, variable);
      if (!chain.empty()) budget.push_back(row_of(report, entry, variable, chain));
    }
  }
  return budget;
}

Json to_json(const std::vector<BudgetRow>& budget) {
  Json rows = Json::array();
  for (const auto& row : budget) {
    Json parts = Json::array();
    for (const auto& part : row.parts) parts.push_back(to_json(part));
    rows.push_back(
        {{"solution", row.solution},
         {"variable", transform::name(row.variable)},
         {"reference", row.reference},
         {"total", row.total},
         {"total_tail", row.total_tail},
         {"tail", {{"from", row.tail_from}, {"to", row.tail_to}, {"bins", row.tail_bins}}},
         {"parts", parts}});
  }
  return rows;
}

}  // namespace fpkcheck::compare
