#include "report/findings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <utility>

#include "compare/agreement.hpp"
#include "compare/solution_assessment.hpp"
#include "report/case_solutions.hpp"
#include "report/verdict/verdict.hpp"

namespace fpkcheck::report {
namespace {

using base::meaning_of;
using problem::DensityEquation;
using problem::ImpactCondition;
using results::CaseResult;
using transform::Solution;
using transform::SolutionRole;
using transform::StateVariable;

using Sentences = std::vector<std::string>;

std::string l1_pair_text(const MarginalDistances& pair) {
  if (pair.has_both_distances()) return fmt::format("{:.2g} and {:.2g}", *pair.y, *pair.ydot);
  return fmt::format("{:.2g}", pair.y ? *pair.y : pair.ydot.value_or(0));
}

MarginalDistances l1_distances(const CaseResult& case_result, const Solution& a,
                               const Solution& b) {
  return {case_result.l1_distance(a.id(), b.id(), StateVariable::y),
          case_result.l1_distance(a.id(), b.id(), StateVariable::ydot)};
}

std::optional<double> l1_standard_error(const CaseResult& case_result, const Solution& a,
                                        const Solution& b, StateVariable variable) {
  const auto* pair = compare::find_pair_distances(case_result.pairs, a.id(), b.id(), variable);
  return pair == nullptr ? std::nullopt : pair->l1_standard_error;
}

/// Returns whether the L1 distances of two solutions are computed over smooth bins (B-spline
/// weights). Only L1 distances over smooth bins have standard errors.
bool has_smooth_distances(const CaseResult& case_result, const Solution& a, const Solution& b) {
  return l1_standard_error(case_result, a, b, StateVariable::y) &&
         l1_standard_error(case_result, a, b, StateVariable::ydot);
}

std::string describe_solution(const Solution& solution) {
  return fmt::format(
      "the {} ({})",
      solution.identity.role == SolutionRole::simulation ? "simulation" : "full jump equation",
      solution.id());
}

std::string capitalise_first_letter(std::string sentence) {
  sentence.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(sentence.front())));
  return sentence;
}

void add_discretisation_errors(const CaseResult& case_result, Sentences& sentences) {
  if (!case_result.budget.empty()) return;  // the error budget has the discretisation errors
  Sentences ids;
  transform::ErrorEstimate largest;
  for (const auto& solution : case_result.solutions) {
    if (solution.identity.role != SolutionRole::equation || !solution.error) continue;
    const auto& error = *solution.error;
    if (!std::isfinite(error.y_l1 + error.ydot_l1 + error.moments.y2 + error.moments.v2)) continue;
    ids.push_back(solution.id());
    largest.y_l1 = std::max(largest.y_l1, error.y_l1);
    largest.ydot_l1 = std::max(largest.ydot_l1, error.ydot_l1);
    largest.moments.y2 = std::max(largest.moments.y2, error.moments.y2);
    largest.moments.v2 = std::max(largest.moments.v2, error.moments.v2);
  }
  if (ids.empty()) return;
  const bool several = ids.size() > 1;
  sentences.push_back(fmt::format(
      "The discretisation error{} of {}, by {} own estimate: {}L1 {}, {:.1g} in E[y^2] and {:.1g} "
      "in E[y'^2].",
      several ? "s" : "", fmt::join(ids, ", "), several ? "their" : "its",
      several ? "at most " : "",
      l1_distances_text(MarginalDistances{largest.y_l1, largest.ydot_l1}), largest.moments.y2,
      largest.moments.v2));
}

void add_approximation_errors(const CaseResult& case_result, Sentences& sentences) {
  Sentences of_equations, of_impacts;
  for (const auto& a : case_result.solutions) {
    for (const auto& b : case_result.solutions) {
      const auto &approximate = a.identity, &exact = b.identity;
      if (approximate.role != SolutionRole::equation || exact.role != SolutionRole::equation)
        continue;
      if (!a.has_status_ok() || !b.has_status_ok() || approximate.method != exact.method) continue;
      const bool known =
          approximate.equation && approximate.impact && exact.equation && exact.impact;
      const bool other_equation = approximate.equation != exact.equation;
      const bool other_impact = approximate.impact != exact.impact;
      const bool costs = other_equation
                             ? !other_impact && exact.equation == DensityEquation::kf
                             : other_impact && approximate.impact == ImpactCondition::delta;
      const MarginalDistances cost = l1_distances(case_result, a, b);
      if (!known || !costs || !cost.has_both_distances()) continue;
      const std::string what =
          other_equation ? fmt::format("{} in place of the {}", meaning_of(*approximate.equation),
                                       meaning_of(*exact.equation))
                         : fmt::format("the impact {} in place of {}",
                                       meaning_of(*approximate.impact), meaning_of(*exact.impact));
      (other_equation ? of_equations : of_impacts)
          .push_back(fmt::format("{} ({}) {}", what, a.id(), l1_distances_text(cost)));
    }
  }
  of_equations.insert(of_equations.end(), of_impacts.begin(), of_impacts.end());
  if (of_equations.empty()) return;
  sentences.push_back(
      fmt::format("L1 error of each approximation: {}.", fmt::join(of_equations, "; ")));
}

void add_residual_based_errors(const CaseResult& case_result, Sentences& sentences) {
  Sentences parts;
  double largest_gap = 0;
  const results::MomentErrorEstimate* first = nullptr;
  for (const auto& own : case_result.moment_error_estimates) {
    const Solution* solution = case_result.find(own.solution);
    if (solution == nullptr || !compare::is_solution_of_full_problem(*solution)) continue;
    if (first == nullptr) first = &own;
    parts.push_back(
        fmt::format("{:.1e} and {:.1e} in {}", own.error.y2, own.error.v2, own.solution));
  }
  if (parts.empty()) return;
  for (const auto& solution : case_result.solutions) {
    if (!solution.smooth_sampling || !compare::is_solution_of_full_problem(solution)) continue;
    largest_gap = std::max({largest_gap, std::abs(solution.moments.y2 - first->corrected.y2),
                            std::abs(solution.moments.v2 - first->corrected.v2)});
  }
  // Returns the number of significant digits that the simulation confirms, or a default number
  // without a simulation.
  const auto digits = [&](double value) {
    constexpr int kDefaultDigits = 7, kMaxDigits = 10;
    if (!(largest_gap > 0)) return kDefaultDigits;
    // The number of confirmed digits may be infinite before an upper limit is applied.
    const double confirmed_digits = 1 + std::trunc(std::log10(std::abs(value) / largest_gap));
    return confirmed_digits > 2 ? static_cast<int>(std::min<double>(confirmed_digits, kMaxDigits))
                                : 2;
  };
  sentences.push_back(fmt::format(
      "Errors of E[y^2] and E[y'^2], estimated from residuals: {}. Corrected moments of {}: "
      "{:.{}g} and {:.{}g}{}.",
      fmt::join(parts, ", "), first->solution, first->corrected.y2, digits(first->corrected.y2),
      first->corrected.v2, digits(first->corrected.v2),
      largest_gap > 0 ? fmt::format(", within {:.0e} of the simulation", largest_gap) : ""));
}

void add_closest_closures(const CaseResult& case_result, Sentences& sentences) {
  const auto& assessment = case_result.assessment;
  const bool any = std::ranges::any_of(case_result.solutions, [](const Solution& s) {
    return s.identity.role == SolutionRole::closure;
  });
  if (assessment.reference.empty() || !any) return;
  auto ranks = assessment.closures_ranked_by_distance();
  if (ranks.empty()) {
    sentences.emplace_back("No closure has status ok.");
    return;
  }
  const auto* nearest = ranks.front();
  std::erase_if(ranks,
                [](const auto* rank) { return *rank->largest_l1_distance() > compare::kCloseL1; });
  if (ranks.empty()) {
    sentences.push_back(
        fmt::format("No closure with status ok is within L1 {} of {}: the closest, {}, has L1 {}.",
                    compare::kCloseL1, assessment.reference, nearest->id,
                    l1_distances_text(MarginalDistances{nearest->y, nearest->ydot})));
    return;
  }
  // Each group has, for one family and formulation, the closest closure to the reference and all
  // closures that are indistinguishable from the closest closure.
  std::map<std::pair<std::string, std::string>, std::vector<const compare::SolutionAssessment*>>
      groups;
  bool several = false;
  for (const auto* rank : ranks) {
    const auto& identity = case_result.find(rank->id)->identity;
    auto& closest = groups[{identity.family, identity.formulation}];
    const bool first = closest.empty();
    if (first || assessment.are_closures_indistinguishable(*closest.front(), *rank)) {
      closest.push_back(rank);
      several = several || !first;
    }
  }
  Sentences parts;
  for (const auto& [group, closest] : groups) {
    Sentences ids;
    MarginalDistances most{0, 0};
    for (const auto* rank : closest) {
      ids.push_back(rank->id);
      most.update_largest_l1_distances(rank->y, rank->ydot);
    }
    const bool tie = ids.size() > 1;
    parts.push_back(fmt::format("{}{} with L1 {}{}", fmt::join(ids, ", "),
                                tie ? " (indistinguishable)" : "", tie ? "at most " : "",
                                l1_distances_text(most)));
  }
  sentences.push_back(fmt::format(
      "Closest to {} among the closures with status ok: {}.{}", assessment.reference,
      fmt::join(parts, "; "),
      several
          ? " Indistinguishable: the distances differ by no more than the error estimate of the "
            "reference."
          : ""));
}

/// @param smooth whether the L1 distance is computed over smooth bins
MarginalDistances sampling_errors(const Solution& solution, bool smooth = false) {
  const auto& stated = smooth ? smallest_known_sampling_errors(solution) : solution.sampling;
  return stated ? MarginalDistances{stated->y, stated->ydot} : MarginalDistances{};
}

void add_sampling_errors(const CaseResult& case_result, Sentences& sentences) {
  if (!case_result.budget.empty()) return;  // the error budget has the sampling errors
  for (const auto& solution : case_result.solutions) {
    const MarginalDistances l1 = sampling_errors(solution);
    if (!l1.has_any_distance() || !solution.standard_errors) continue;
    const auto& moments = solution.standard_errors->moments;
    // Samples of y alone have no moments of y'.
    const std::string of_velocity =
        std::isfinite(moments.v2) ? fmt::format(" and {:.1g} in E[y'^2]", moments.v2) : "";
    sentences.push_back(fmt::format(
        "The sampling error of {}: on average L1 {}; standard errors {:.1g} in E[y^2]{}.",
        solution.id(), l1_distances_text(l1), moments.y2, of_velocity));
  }
}

void add_kick_interval_errors(const CaseResult& case_result, Sentences& sentences) {
  for (const auto& solution : case_result.solutions) {
    if (!solution.error || !solution.standard_errors) continue;
    sentences.push_back(fmt::format(
        "The interval between noise kicks in {} causes errors of about L1 {}, {:.1g} in E[y^2] and "
        "{:.1g} in E[y'^2].",
        solution.id(),
        l1_distances_text(MarginalDistances{solution.error->y_l1, solution.error->ydot_l1}),
        solution.error->moments.y2, solution.error->moments.v2));
  }
}

// Returns the sampling error of the difference of two independent estimates, whose variances add.
MarginalDistances combined_errors(const MarginalDistances& one, const MarginalDistances& other) {
  const auto sum = [](const auto& a, const auto& b) {
    return a || b ? std::optional(std::hypot(a.value_or(0), b.value_or(0))) : std::nullopt;
  };
  return {sum(one.y, other.y), sum(one.ydot, other.ydot)};
}

MarginalDistances largest_explained_l1_distance(const Solution& one, const Solution& other,
                                                bool smooth) {
  return {compare::largest_explained_l1_distance(one, other, StateVariable::y, smooth),
          compare::largest_explained_l1_distance(one, other, StateVariable::ydot, smooth)};
}

// Returns the clause on the errors of an L1 distance: "; source expected; all errors explain up to
// .., exceeded by chance in 1 run of 1000: the densities agree".
std::string agreement_text(const MarginalDistances& gap, const MarginalDistances& expected,
                           const MarginalDistances& explained, const std::string& error_source) {
  const auto within = [](const auto& difference, const auto& most) {
    return !difference || !most || *difference <= *most;
  };
  const bool agree = within(gap.y, explained.y) && within(gap.ydot, explained.ydot);
  return fmt::format(
      "; {} {}; all errors explain up to {} (exceeded by chance in 1 run of {:.0f}): the "
      "densities {}",
      error_source, l1_distances_text(expected), l1_pair_text(explained),
      1 / compare::kAgreementSignificance, agree ? "agree" : "disagree");
}

/// The L1 error of one marginal density, measured by the distance from a simulation with control
/// variates.
struct L1ErrorMeasuredBySimulation {
  double l1, error, chance, stated;
  bool explained;  ///< whether the errors of both solutions explain l1 (compare/agreement.hpp)

  /// Returns whether the L1 error of a solution exceeds three expected sampling errors of the
  /// simulation. An L1 error below three expected sampling errors is mostly sampling error.
  bool is_significant() const { return l1 > 3 * chance; }
  bool exceeds_stated_error() const { return std::isfinite(stated) && !explained; }
};

L1ErrorMeasuredBySimulation measure_l1_error(const CaseResult& case_result,
                                             const Solution& solution, const Solution& measure,
                                             StateVariable variable) {
  const double l1 = case_result.l1_distance(solution.id(), measure.id(), variable).value_or(0);
  const auto most = compare::largest_explained_l1_distance(solution, measure, variable, true);
  return {
      .l1 = l1,
      .error = *l1_standard_error(case_result, solution, measure, variable),
      .chance = expected_l1_error(*smallest_known_sampling_errors(measure), variable).value_or(0),
      .stated = compare::l1_error_estimate(solution, variable),
      .explained = !most || l1 <= *most};
}

// Returns the text of a measured L1 error: "2.7e-05 +- 5e-07 in p(y) (estimate 2.8e-05)".
std::string measured_error_text(const L1ErrorMeasuredBySimulation& marginal_error,
                                StateVariable variable) {
  const std::string stated = std::isfinite(marginal_error.stated)
                                 ? fmt::format(" (estimate {:.2g})", marginal_error.stated)
                                 : std::string();
  const char* density = variable == StateVariable::y ? "p(y)" : "p(y')";
  if (!marginal_error.is_significant()) {
    return fmt::format("at most {:.1g} (3 sampling errors of the simulation) in {}{}",
                       3 * marginal_error.chance, density, stated);
  }
  return fmt::format("{:.2g} +- {:.0g} in {}{}", marginal_error.l1, marginal_error.error, density,
                     stated);
}

void add_measured_errors(const CaseResult& case_result, Sentences& sentences) {
  const Solution* measure = case_result.reference_solution();
  if (measure == nullptr || !measure->smooth_sampling) return;
  for (const Solution* other : solutions_of_full_problem(case_result)) {
    if (other == measure || !has_smooth_distances(case_result, *other, *measure)) continue;
    const L1ErrorMeasuredBySimulation y =
        measure_l1_error(case_result, *other, *measure, StateVariable::y);
    const L1ErrorMeasuredBySimulation ydot =
        measure_l1_error(case_result, *other, *measure, StateVariable::ydot);
    const bool more = y.exceeds_stated_error() || ydot.exceeds_stated_error();
    sentences.push_back(fmt::format(
        "{} has an L1 error of {} and {} over smooth bins, measured by {}{}.",
        capitalise_first_letter(describe_solution(*other)),
        measured_error_text(y, StateVariable::y), measured_error_text(ydot, StateVariable::ydot),
        describe_solution(*measure), more ? ": larger than the estimate" : ""));
  }
}

void add_agreement_of_references(const CaseResult& case_result, Sentences& sentences) {
  const auto all = solutions_of_full_problem(case_result);
  for (std::size_t k = 1; k < all.size(); ++k) {
    const Solution &reference = *all.front(), &other = *all[k];
    if (reference.smooth_sampling && has_smooth_distances(case_result, other, reference)) continue;
    const MarginalDistances gap = l1_distances(case_result, reference, other);
    if (!gap.has_both_distances()) continue;
    const bool smooth = has_smooth_distances(case_result, reference, other);
    const MarginalDistances own = sampling_errors(reference, smooth),
                            others = sampling_errors(other, smooth);
    std::string chance;
    if (own.has_any_distance() || others.has_any_distance()) {
      const std::string error_source =
          own.has_any_distance() && others.has_any_distance()
              ? "their sampling errors account for about"
              : fmt::format("the sampling error of {} is",
                            describe_solution(own.has_any_distance() ? reference : other));
      chance =
          agreement_text(gap, combined_errors(own, others),
                         largest_explained_l1_distance(reference, other, smooth), error_source);
    }
    sentences.push_back(capitalise_first_letter(
        fmt::format("{} and {} differ by L1 {}{}.", describe_solution(reference),
                    describe_solution(other), l1_distances_text(gap), chance)));
  }
}

void add_distances_of_external_densities(const CaseResult& case_result, Sentences& sentences) {
  const auto all = solutions_of_full_problem(case_result);
  for (const auto& given : case_result.solutions) {
    if (given.identity.role != SolutionRole::external) continue;
    for (const Solution* reference : all) {
      const MarginalDistances gap = l1_distances(case_result, given, *reference);
      if (!gap.has_any_distance()) continue;
      // The comparison with an external density covers only those marginal densities for which the
      // external density has standard errors.
      const bool smooth = has_smooth_distances(case_result, given, *reference);
      const MarginalDistances own = sampling_errors(given);
      MarginalDistances other = sampling_errors(*reference, smooth);
      MarginalDistances explained = largest_explained_l1_distance(given, *reference, smooth);
      for (auto* part : {&other, &explained}) {
        if (!own.y) part->y.reset();
        if (!own.ydot) part->ydot.reset();
      }
      std::string chance;
      if (own.has_any_distance()) {
        chance = agreement_text(
            gap, combined_errors(own, other), explained,
            fmt::format("its standard errors{} account for about",
                        other.has_any_distance() ? " and those of " + reference->id() : ""));
      }
      sentences.push_back(fmt::format("{} differs from {} by L1 {}{}.", given.id(),
                                      describe_solution(*reference), l1_distances_text(gap),
                                      chance));
    }
  }
}

void add_solver_notes(const CaseResult& case_result, Sentences& sentences) {
  constexpr std::string_view kNotes = "notes[";
  for (const auto& solution : case_result.solutions) {
    std::map<std::string, Sentences> notes;  // notes, by the prefix of the path of the metric
    for (const auto& observation : solution.metrics) {
      const auto mark = observation.path.rfind(kNotes);
      const auto* note = std::get_if<std::string>(&observation.value);
      if (note == nullptr || mark == std::string::npos) continue;
      if (mark > 0 && observation.path[mark - 1] != '.') continue;
      notes[observation.path.substr(0, mark)].push_back(*note);
    }
    for (const auto& [place, own] : notes) {
      const auto file = transform::metric_text(solution.metrics, place + "file");
      sentences.push_back(
          fmt::format("Note on {}: {}.",
                      file ? std::filesystem::path(*file).filename().string() : solution.id(),
                      fmt::join(own, "; ")));
    }
  }
}

}  // namespace

std::vector<std::string> case_finding_sentences(const CaseResult& case_result) {
  Sentences sentences = guaranteed_bounds_findings(case_result);
  if (case_result.solutions.size() > 1)
    sentences.push_back(reference_description_text(case_result));
  add_discretisation_errors(case_result, sentences);
  add_sampling_errors(case_result, sentences);
  add_kick_interval_errors(case_result, sentences);
  add_approximation_errors(case_result, sentences);
  add_closest_closures(case_result, sentences);
  add_measured_errors(case_result, sentences);
  add_residual_based_errors(case_result, sentences);
  add_agreement_of_references(case_result, sentences);
  add_distances_of_external_densities(case_result, sentences);
  add_solver_notes(case_result, sentences);
  return sentences;
}

}  // namespace fpkcheck::report
