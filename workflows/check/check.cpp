#include "workflows/check/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "base/input_error.hpp"
#include "workflows/check/claims.hpp"

namespace fpkcheck::check {
namespace {

template <class List>
void append(List& list, List more) {
  std::ranges::move(more, std::back_inserter(list));
}

Claims claims_of(const results::Case& one, const results::Case& other, bool is_baseline,
                 const Tolerances& tolerances) {
  Claims claims;
  for (transform::Solution solution : one.solutions) {
    const auto* again = other.find(solution.id());
    if (is_baseline && again != nullptr) {
      solution.observations = described(std::move(solution.observations), again->observations);
    }
    append(claims, solution_claims(solution, tolerances));
  }
  append(claims, distance_claims(one, other, tolerances));
  append(claims, budget_claims(one, other, tolerances));
  return claims;
}

}  // namespace

std::vector<Figure> Check::moved() const {
  std::vector<Figure> result;
  std::ranges::copy_if(figures, std::back_inserter(result), &Figure::moved);
  return result;
}

bool Check::agrees() const { return std::ranges::none_of(figures, &Figure::moved); }

Check check(const results::Run& baseline, const results::Run& now, const Tolerances& tolerances,
            bool with_marginals) {
  Check result{tolerances, {}, 0, {}};
  for (const results::Case& was : baseline.cases) {
    const auto is = std::ranges::find(now.cases, was.name(), &results::Case::name);
    if (is == now.cases.end()) {
      throw InputError(fmt::format("case {} is missing in the new run", was.name()));
    }
    result.solutions += was.solutions.size();
    append(result.figures, held_against(was.name(), claims_of(was, *is, true, tolerances),
                                        claims_of(*is, was, false, tolerances)));
    if (with_marginals) append(result.figures, marginal_figures(was, *is, tolerances));
  }
  return result;
}

std::vector<KindSummary> by_kind(const Check& check) {
  std::vector<KindSummary> kinds;
  for (const auto& entry : kFigureKindNames) {
    KindSummary summary{entry.value};
    for (const auto& figure : check.figures) {
      if (figure.kind != entry.value) continue;
      ++summary.count;
      if (figure.moved()) {
        ++summary.moved;
      } else if (summary.largest == nullptr || figure.share() > summary.largest->share()) {
        summary.largest = &figure;
      }
    }
    if (summary.count > 0) kinds.push_back(summary);
  }
  return kinds;
}

}  // namespace fpkcheck::check
