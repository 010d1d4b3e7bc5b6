#include "compare/check/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "compare/check/figures.hpp"
#include "compare/summary_view.hpp"
#include "problem/input_error.hpp"

namespace fpkcheck::compare {
namespace {

using Json = nlohmann::ordered_json;

const Json* find_case(const Json& summary, const Json& name) {
  for (const Json& one : summary.at("cases")) {
    if (one.at("name") == name) return &one;
  }
  return nullptr;
}

}  // namespace

std::vector<Figure> Check::moved() const {
  std::vector<Figure> result;
  std::ranges::copy_if(figures, std::back_inserter(result), &Figure::moved);
  return result;
}

bool Check::agrees() const { return std::ranges::none_of(figures, &Figure::moved); }

Check check(const SavedRun& baseline, const SavedRun& now, const Tolerances& tolerances,
            bool with_marginals) try {
  Check result{tolerances, {}, 0, {}};
  for (const Json& one : baseline.summary.at("cases")) {
    const Json* again = find_case(now.summary, one.at("name"));
    if (again == nullptr) {
      throw InputError(
          fmt::format("case {} is missing in the new run", one.at("name").get<std::string>()));
    }
    const CaseOfRun was{one, baseline.marginals}, is{*again, now.marginals};
    result.solutions += one.at("solutions").size();
    std::ranges::move(solution_figures(was, is, tolerances), std::back_inserter(result.figures));
    std::ranges::move(detail_figures(was, is, tolerances), std::back_inserter(result.figures));
    if (with_marginals) {
      std::ranges::move(marginal_figures(was, is, tolerances), std::back_inserter(result.figures));
    }
    std::ranges::move(distance_figures(was, is, tolerances), std::back_inserter(result.figures));
    std::ranges::move(budget_figures(was, is, tolerances), std::back_inserter(result.figures));
  }
  return result;
} catch (const Json::exception& error) {
  throw InputError(
      fmt::format("the baseline is not a whole summary ({}; run again)", said_by(error)));
}

}  // namespace fpkcheck::compare
