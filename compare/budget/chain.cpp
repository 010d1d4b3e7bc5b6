#include "compare/budget/chain.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace fpkcheck::compare {
namespace {

using problem::Impact;
using transform::Marginal;
using transform::Variable;

constexpr const char* kDiscretisation = "discretisation";

const Marginal* find_marginal(const CaseReport& report, const std::string& id, Variable variable) {
  for (const auto& found : report.marginals) {
    if (found.solution != id || found.variable != variable) continue;
    const bool finite =
        std::ranges::all_of(found.marginal.density, [](double p) { return std::isfinite(p); });
    return finite ? &found.marginal : nullptr;
  }
  return nullptr;
}

/// Builds a chain node by node and remembers the links that no node stands for yet.
class Chain {
 public:
  Chain(const CaseReport& report, Variable variable, const std::string& closure,
        const Marginal& marginal)
      : report_(report), variable_(variable), nodes_{{closure, "", marginal, 0.0}} {}

  void finite_differences(const char* link, const std::string& equation, Impact impact) {
    pending_.push_back(link);
    for (const auto& entry : report_.entries) {
      const auto& s = entry.solution;
      if (s.method != "fd" || s.equation != equation || s.impact != impact) continue;
      if (const auto* m = usable(entry)) {
        append({s.id, "", *m, discretisation_error(s, *m)});
        if (equation == "kf" && impact == Impact::map) full_ = &entry;
        return;
      }
    }
  }

  void limit() {
    pending_.push_back(kDiscretisation);
    if (!full_ || !full_->solution.extrapolation) return;
    append({full_->solution.id + " limit", "", limit_of(full_->solution), 0.0});
  }

  void simulation() {
    pending_.push_back("sampling");
    // Without finite differences on the way nothing was discretised.
    if (nodes_.size() == 1) std::erase(pending_, kDiscretisation);
    for (const auto& entry : report_.entries) {
      if (entry.solution.method != "mcs" || entry.solution.equation != "kf") continue;
      if (const auto* m = usable(entry)) {
        append({entry.solution.id, "", *m, std::nullopt});
        simulated_ = true;
        return;
      }
    }
  }

  std::vector<ChainNode> nodes() && {
    return full_ || simulated_ ? std::move(nodes_) : std::vector<ChainNode>{};
  }

 private:
  const Marginal* usable(const Entry& entry) const {
    return entry.solution.status == transform::Status::ok
               ? find_marginal(report_, entry.solution.id, variable_)
               : nullptr;
  }

  Marginal limit_of(const transform::Solution& solution) const {
    return transform::limit_marginal(solution, variable_, edges(report_.axes, variable_));
  }

  std::optional<double> discretisation_error(const transform::Solution& s,
                                             const Marginal& m) const {
    if (!s.extrapolation) return std::nullopt;
    return distances(m, limit_of(s)).l1;
  }

  void append(ChainNode node) {
    node.link = fmt::format("{}", fmt::join(pending_, " + "));
    pending_.clear();
    nodes_.push_back(std::move(node));
  }

  const CaseReport& report_;
  Variable variable_;
  std::vector<ChainNode> nodes_;
  std::vector<std::string> pending_;
  const Entry* full_ = nullptr;
  bool simulated_ = false;
};

}  // namespace

std::vector<ChainNode> budget_chain(const CaseReport& report, const Entry& closure,
                                    Variable variable) {
  const auto& equation = closure.solution.equation;
  const auto impact = closure.solution.impact;
  const Marginal* marginal = find_marginal(report, closure.solution.id, variable);
  if (!marginal) return {};
  Chain chain(report, variable, closure.solution.id, *marginal);
  chain.finite_differences("closure", equation, impact);
  if (impact != Impact::map) chain.finite_differences("impact", equation, Impact::map);
  if (equation != "kf") {
    chain.finite_differences(equation == "white" ? "white noise" : "truncation", "kf", Impact::map);
  }
  chain.limit();
  chain.simulation();
  return std::move(chain).nodes();
}

}  // namespace fpkcheck::compare
