#include "compare/findings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>

#include "compare/summary_view.hpp"

namespace fpkcheck::compare {
namespace {

using Json = nlohmann::ordered_json;
using transform::Variable;

/// L1 distances in both variables.
struct Cost {
  double y;
  double ydot;
};

std::string text(const Cost& cost) {
  return fmt::format("{:.2g} in p(y) and {:.2g} in p(y')", cost.y, cost.ydot);
}

std::optional<Cost> cost(const Json& summary_case, std::string_view id,
                         std::string_view reference) {
  if (!usable(summary_case, id) || !usable(summary_case, reference)) return std::nullopt;
  const auto y = l1_between(summary_case, id, reference, Variable::y);
  const auto ydot = l1_between(summary_case, id, reference, Variable::ydot);
  if (!y || !ydot) return std::nullopt;
  return Cost{*y, *ydot};
}

void say_what_approximations_cost(const Json& summary_case, std::vector<std::string>& sentences) {
  struct Approximation {
    const char* id;
    const char* reference;
    const char* what;
  };
  constexpr Approximation kApproximations[] = {
      {"fd-white", "fd-kf", "replacing the impulses by white noise costs L1"},
      {"fd-km4", "fd-kf", "cutting the Kramers-Moyal series after the fourth derivative costs"},
      {"fd-km4-delta", "fd-km4", "the impact to first order in 1-r costs"},
  };
  std::vector<std::string> parts;
  for (const auto& [id, reference, what] : kApproximations) {
    if (const auto found = cost(summary_case, id, reference)) {
      parts.push_back(fmt::format("{} {}", what, text(*found)));
    }
  }
  if (parts.empty()) return;
  std::string sentence = fmt::format("{}.", fmt::join(parts, "; "));
  sentence.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(sentence.front())));
  sentences.push_back(sentence);
}

void say_which_closure_is_closest(const Json& summary_case, std::vector<std::string>& sentences) {
  const bool simulated = usable(summary_case, "mcs");
  const std::string reference = simulated ? "mcs" : "fd-kf";
  struct Closure {
    std::string id;
    Cost cost;
  };
  std::map<std::string, Closure> closest;  // by formulation
  bool any = false;
  for (const auto& solution : summary_case.at("solutions")) {
    if (solution.at("method") != "epc") continue;
    any = true;
    const auto id = solution.at("id").get<std::string>();
    const auto found = cost(summary_case, id, reference);
    if (!found) continue;
    const auto formulation = solution.value("formulation", std::string("given"));
    const auto [best, first] = closest.try_emplace(formulation, Closure{id, *found});
    if (!first && found->y + found->ydot < best->second.cost.y + best->second.cost.ydot) {
      best->second = {id, *found};
    }
  }
  if (closest.empty()) {
    if (any && usable(summary_case, reference)) {
      sentences.push_back("No exponential-polynomial closure gave an admissible density.");
    }
    return;
  }
  std::vector<std::string> parts;
  for (const auto& [formulation, closure] : closest) {
    parts.push_back(fmt::format("{} with L1 {}", closure.id, text(closure.cost)));
  }
  sentences.push_back(fmt::format("The admissible closure closest to the {}: {}.",
                                  simulated ? "simulation" : "full jump equation",
                                  fmt::join(parts, "; ")));
}

void say_whether_the_references_agree(const Json& summary_case,
                                      std::vector<std::string>& sentences) {
  const auto gap = cost(summary_case, "fd-kf", "mcs");
  if (!gap) return;
  std::string sentence =
      fmt::format("The full jump equation (fd-kf) and the simulation differ by {}", text(*gap));
  const Json* simulation = find_solution(summary_case, "mcs");
  const auto sampling = simulation->find("sampling_l1");
  if (sampling != simulation->end()) {
    const auto y = number(*sampling, "y"), ydot = number(*sampling, "ydot");
    if (y && ydot) {
      sentence += fmt::format("; the simulation's own sampling error is {}", text({*y, *ydot}));
      const auto y_99 = number(*sampling, "y_99"), ydot_99 = number(*sampling, "ydot_99");
      if (y_99 && ydot_99) {
        sentence += fmt::format(" (99 runs of 100 stay below {:.2g} and {:.2g})", *y_99, *ydot_99);
      }
      // Without that, as in older summaries: single runs reach nearly twice the expectation.
      constexpr double kScatter = 2;
      const bool explained =
          gap->y <= y_99.value_or(kScatter * *y) && gap->ydot <= ydot_99.value_or(kScatter * *ydot);
      sentence += explained ? ", which explains the difference"
                            : ", which does not explain all of the difference";
    }
  }
  sentences.push_back(sentence + '.');
}

/// Of one solution, or the largest of several.
struct DiscretisationError {
  Cost l1{0, 0};
  double y2 = 0, v2 = 0;
};

std::optional<DiscretisationError> discretisation_error(const Json& solution) {
  const auto error = solution.find("error");
  if (error == solution.end() || !error->is_object()) return std::nullopt;
  const auto y = number(*error, "y_l1"), ydot = number(*error, "ydot_l1");
  const auto y2 = number(error->at("moments"), "y2"), v2 = number(error->at("moments"), "v2");
  if (!y || !ydot || !y2 || !v2) return std::nullopt;
  return DiscretisationError{{*y, *ydot}, *y2, *v2};
}

void say_discretisation_errors(const Json& summary_case, std::vector<std::string>& sentences) {
  const auto budget = summary_case.find("budget");               // older runs have none
  if (budget != summary_case.end() && !budget->empty()) return;  // it has them
  std::vector<std::string> ids;
  DiscretisationError largest;
  for (const auto& solution : summary_case.at("solutions")) {
    const auto error = discretisation_error(solution);
    if (!error) continue;
    ids.push_back(solution.at("id").get<std::string>());
    largest = {{std::max(largest.l1.y, error->l1.y), std::max(largest.l1.ydot, error->l1.ydot)},
               std::max(largest.y2, error->y2),
               std::max(largest.v2, error->v2)};
  }
  if (ids.empty()) return;
  const bool several = ids.size() > 1;
  sentences.push_back(fmt::format(
      "The discretisation error{} of {}, estimated from two coarser grids: {}L1 {}, {:.1g} in "
      "E[y^2] and {:.1g} in E[y'^2].",
      several ? "s" : "", fmt::join(ids, ", "), several ? "at most " : "", text(largest.l1),
      largest.y2, largest.v2));
}

/// L1 distances to a reference in the variables that a file gave.
struct Gap {
  std::optional<double> y, ydot;
  bool any() const { return y || ydot; }
};

std::string text(const Gap& gap) {
  if (gap.y && gap.ydot) return text(Cost{*gap.y, *gap.ydot});
  return gap.y ? fmt::format("{:.2g} in p(y)", *gap.y)
               : fmt::format("{:.2g} in p(y')", gap.ydot.value_or(0));
}

std::string figures(const Gap& gap) {
  if (gap.y && gap.ydot) return fmt::format("{:.2g} and {:.2g}", *gap.y, *gap.ydot);
  return fmt::format("{:.2g}", gap.y ? *gap.y : gap.ydot.value_or(0));
}

Gap gap_to(const Json& summary_case, std::string_view id, std::string_view reference) {
  if (!usable(summary_case, reference)) return {};
  return {l1_between(summary_case, id, reference, Variable::y),
          l1_between(summary_case, id, reference, Variable::ydot)};
}

/// What chance does to a solution: what one expects, and what 99 runs of 100 stay below.
struct Chance {
  Gap expected, in_99;
};

Chance sampling_error(const Json* solution) {
  if (solution == nullptr || !solution->contains("sampling_l1")) return {};
  const auto& sampling = solution->at("sampling_l1");
  // Without that, as in older summaries: single runs reach nearly twice the expectation.
  constexpr double kScatter = 2;
  const auto in_99 = [&](const char* key_99, const std::optional<double>& expected) {
    const auto own = number(sampling, key_99);
    return own || !expected ? own : std::optional(kScatter * *expected);
  };
  const Gap expected{number(sampling, "y"), number(sampling, "ydot")};
  return {expected, {in_99("y_99", expected.y), in_99("ydot_99", expected.ydot)}};
}

// The error of a difference whose parts are independent.
Gap together(const Gap& own, const Gap& other, const Gap& gap) {
  const auto sum = [](const auto& mine, const auto& theirs, const auto& difference) {
    return mine && difference ? std::optional(std::hypot(*mine, theirs.value_or(0))) : std::nullopt;
  };
  return {sum(own.y, other.y, gap.y), sum(own.ydot, other.ydot, gap.ydot)};
}

// "; its standard errors account for ..., which explains that", where the file has any.
std::string whether_chance_explains(const Json& solution, const Json* simulation, const Gap& gap) {
  const Chance own = sampling_error(&solution), other = sampling_error(simulation);
  const Gap expected = together(own.expected, other.expected, gap);
  const Gap in_99 = together(own.in_99, other.in_99, gap);
  if (!expected.any()) return "";
  const auto within = [](const auto& difference, const auto& most) {
    return !most || *difference <= *most;
  };
  const bool explained = within(gap.y, in_99.y) && within(gap.ydot, in_99.ydot);
  return fmt::format(
      "; its standard errors{} account for about {} (99 runs of 100 stay below {}), which {} that",
      other.expected.any() ? " and the simulation's" : "", text(expected), figures(in_99),
      explained ? "explains" : "does not explain");
}

void say_how_far_files_are(const Json& summary_case, std::vector<std::string>& sentences) {
  for (const auto& solution : summary_case.at("solutions")) {
    if (solution.at("method") != "file") continue;
    const auto id = solution.at("id").get<std::string>();
    const Gap to_simulation = gap_to(summary_case, id, "mcs");
    const Gap to_full = gap_to(summary_case, id, "fd-kf");
    if (to_simulation.any()) {
      sentences.push_back(fmt::format(
          "{} differs from the simulation by L1 {}{}.", id, text(to_simulation),
          whether_chance_explains(solution, find_solution(summary_case, "mcs"), to_simulation)));
    }
    if (to_full.any()) {
      sentences.push_back(fmt::format("{} differs from the full jump equation (fd-kf) by L1 {}{}.",
                                      id, text(to_full),
                                      whether_chance_explains(solution, nullptr, to_full)));
    }
    for (const auto& file : solution.at("files")) {
      const auto& notes = file.at("notes");
      if (notes.empty()) continue;
      const std::filesystem::path path(file.at("file").get<std::string>());
      sentences.push_back(fmt::format("Of {}: {}.", path.filename().string(),
                                      fmt::join(notes.get<std::vector<std::string>>(), "; ")));
    }
  }
}

}  // namespace

std::vector<std::string> findings(const Json& summary_case) {
  std::vector<std::string> sentences;
  say_discretisation_errors(summary_case, sentences);
  say_what_approximations_cost(summary_case, sentences);
  say_which_closure_is_closest(summary_case, sentences);
  say_whether_the_references_agree(summary_case, sentences);
  say_how_far_files_are(summary_case, sentences);
  return sentences;
}

}  // namespace fpkcheck::compare
