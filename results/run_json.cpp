#include "results/run_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "base/input_error.hpp"
#include "base/text/printable_text.hpp"
#include "compare/solution_assessment.hpp"
#include "results/json_conversions.hpp"
#include "results/run.hpp"

namespace fpkcheck::results {
namespace {

using compare::DensityDistances;
using compare::ErrorBudgetPart;
using compare::ErrorBudgetRow;
using compare::SolutionPairDistances;
using transform::StateVariable;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Json pair_distances_json(const SolutionPairDistances& pair) {
  const DensityDistances& d = pair.distances;
  Json tail = Json::array();
  for (const auto& part : d.log10_tail) {
    tail.push_back({{"from", part.from},
                    {"to", part.to},
                    {"mean_abs", part.mean_abs},
                    {"bins", part.bins},
                    {"left_out", part.omitted_bin_count}});
  }
  Json json{{"a", pair.a},       {"b", pair.b},  {"variable", name(pair.variable)}, {"l1", d.l1},
            {"l2", d.l2},        {"sup", d.sup}, {"hellinger", d.hellinger},        {"kl", d.kl},
            {"log10_tail", tail}};
  if (pair.l1_standard_error) json["l1_standard_error"] = *pair.l1_standard_error;
  return json;
}

Json budget_part_json(const ErrorBudgetPart& part) {
  Json json{{"name", part.error_budget_part_name()},
            {"from", part.from},
            {"to", part.to},
            {"l1", part.l1},
            {"tail", part.tail}};
  if (part.expected) {
    json["expected"] = *part.expected;
    json["in_99"] = number_or_null_json(part.quantile_99);
  } else {
    json["uncertainty"] = number_or_null_json(part.uncertainty);
  }
  if (part.standard_error) json["standard_error"] = *part.standard_error;
  return json;
}

Json budget_row_json(const ErrorBudgetRow& row) {
  Json parts = Json::array();
  for (const auto& part : row.parts) parts.push_back(budget_part_json(part));
  return {{"solution", row.solution},
          {"variable", name(row.variable)},
          {"reference", row.reference},
          {"total", row.total},
          {"total_tail", row.total_tail},
          {"tail", {{"from", row.tail_from}, {"to", row.tail_to}, {"bins", row.tail_bins}}},
          {"parts", parts}};
}

Json guaranteed_bound_json(const compare::GuaranteedBound& bound) {
  return {{"functional", bound.functional}, {"lower", bound.lower}, {"upper", bound.upper}};
}

template <class Element>
Json list_to_json(const std::vector<Element>& elements, Json (*element_to_json)(const Element&)) {
  Json list = Json::array();
  for (const auto& element : elements) list.push_back(element_to_json(element));
  return list;
}

Json bounds_json(const compare::GuaranteedBounds& bounds) {
  return {{"reason", bounds.reason},
          {"seconds", bounds.seconds},
          {"each", list_to_json(bounds.each, guaranteed_bound_json)}};
}

Json moment_error_estimate_json(const MomentErrorEstimate& own) {
  return {{"solution", own.solution},
          {"corrected", moments_to_json(own.corrected)},
          {"error", moments_to_json(own.error)}};
}

Json limiting_error_json(const compare::ClosuresWithSameLimitingError& group) {
  return {{"part", group.part.empty() ? Json() : Json(group.part)},
          {"solutions", group.closures},
          {"least_fraction", group.least_fraction},
          {"greatest_fraction", group.greatest_fraction}};
}

Json assessment_json(const compare::SolutionsAssessment& assessment) {
  Json json{{"reference", Json()}, {"confirmation", Json()}, {"solutions", Json::array()}};
  if (!assessment.reference.empty()) {
    json["reference"] = {
        {"solution", assessment.reference},
        {"selected_by", assessment.is_reference_chosen_by_user        ? "user"
                        : assessment.is_reference_selected_by_error() ? "error_estimate"
                                                                      : "trust"},
        {"y_l1", assessment.reference_y_l1},
        {"ydot_l1", assessment.reference_ydot_l1}};
  }
  if (const auto& second = assessment.confirmation)
    json["confirmation"] = {{"solution", second->id}, {"agrees", second->has_agreement}};
  for (const auto& solution : assessment.solutions) {
    json["solutions"].push_back({{"solution", solution.id},
                                 {"agreement", name(solution.agreement)},
                                 {"y_l1", number_or_null_json(solution.y)},
                                 {"ydot_l1", number_or_null_json(solution.ydot)},
                                 {"rank", solution.rank ? Json(*solution.rank) : Json()}});
  }
  const auto& [groups, has_reference_disagreement] = assessment.limiting_errors;
  json["limiting_errors"] = list_to_json(groups, limiting_error_json);
  json["reference_disagreement"] = has_reference_disagreement;
  return json;
}

Json case_json(const CaseResult& case_result) {
  Json json = problem_to_json(case_result.problem);
  json["solutions"] = list_to_json(case_result.solutions, solution_json);
  json["comparisons"] = list_to_json(case_result.pairs, pair_distances_json);
  json["budget"] = list_to_json(case_result.budget, budget_row_json);
  json["limits"] = limiting_errors_text(case_result);
  if (case_result.bounds) json["bounds"] = bounds_json(*case_result.bounds);
  if (!case_result.moment_error_estimates.empty())
    json["own_errors"] =
        list_to_json(case_result.moment_error_estimates, moment_error_estimate_json);
  const auto& reference = case_result.assessment.reference;
  json["reference"] = reference.empty() ? Json() : Json(reference);
  json["assessment"] = assessment_json(case_result.assessment);
  return json;
}

StateVariable state_variable_from_json(const Json& object) {
  const auto text = object.at("variable").get<std::string>();
  const auto variable = base::enum_from_name<StateVariable>(text);
  if (!variable)
    throw InputError(fmt::format("variable {} (must be y or ydot)", base::in_quotes(text)));
  return *variable;
}

// Returns the number in a JSON value, or `default_value` for null, which represents a non-finite
// number.
double number_or_default(double default_value, const Json& value) {
  return value.is_null() ? default_value : value.get<double>();
}

SolutionPairDistances pair_distances_from_json(const Json& json) {
  SolutionPairDistances pair{json.at("a"),
                             json.at("b"),
                             state_variable_from_json(json),
                             {},
                             optional_number_at_key(json, "l1_standard_error")};
  DensityDistances& d = pair.distances;
  d.l1 = number_or_default(kNotANumber, json.at("l1"));
  d.l2 = number_or_default(kNotANumber, json.at("l2"));
  d.sup = number_or_default(kNotANumber, json.at("sup"));
  d.hellinger = number_or_default(kNotANumber, json.at("hellinger"));
  // In JSON files null represents both infinity and NaN. A finite L1 distance implies finite
  // densities, for which the Kullback-Leibler divergence may be infinite but not NaN.
  d.kl = number_or_default(std::isfinite(d.l1) ? kInfinity : kNotANumber, json.at("kl"));
  for (const auto& tail : json.at("log10_tail")) {
    d.log10_tail.push_back({.from = tail.at("from"),
                            .to = tail.at("to"),
                            .mean_abs = number_or_default(kNotANumber, tail.at("mean_abs")),
                            .bins = integer_at_key(tail, "bins"),
                            .omitted_bin_count = integer_at_key(tail, "left_out")});
  }
  return pair;
}

ErrorBudgetRow budget_row_from_json(const Json& json) {
  const Json& tail = json.at("tail");
  ErrorBudgetRow row{.solution = json.at("solution"),
                     .variable = state_variable_from_json(json),
                     .reference = json.at("reference"),
                     .total = number_or_default(kNotANumber, json.at("total")),
                     .total_tail = number_or_default(kNotANumber, json.at("total_tail")),
                     .tail_from = tail.at("from"),
                     .tail_to = tail.at("to"),
                     .tail_bins = integer_at_key(tail, "bins"),
                     .parts = {}};
  for (const auto& part : json.at("parts")) {
    row.parts.push_back(
        {.approximations = compare::parse_approximations(part.at("name").get<std::string>()),
         .from = part.at("from"),
         .to = part.at("to"),
         .l1 = number_or_default(kNotANumber, part.at("l1")),
         .tail = number_or_default(kNotANumber, part.at("tail")),
         .uncertainty = optional_number_at_key(part, "uncertainty"),
         .expected = optional_number_at_key(part, "expected"),
         .quantile_99 = optional_number_at_key(part, "in_99"),
         .standard_error = optional_number_at_key(part, "standard_error")});
  }
  if (row.parts.empty()) throw InputError("a row of \"budget\" has no parts; run again");
  return row;
}

compare::GuaranteedBounds bounds_from_json(const Json& json) {
  compare::GuaranteedBounds bounds{
      .reason = json.at("reason"), .seconds = json.at("seconds"), .each = {}};
  for (const auto& bound : json.at("each")) {
    bounds.each.push_back({bound.at("functional"), number_or_default(-kInfinity, bound.at("lower")),
                           number_or_default(kInfinity, bound.at("upper"))});
  }
  return bounds;
}

compare::ClosuresWithSameLimitingError limiting_error_from_json(
    const Json& json, std::span<const ErrorBudgetRow> budget) {
  compare::ClosuresWithSameLimitingError group{.part = {},
                                               .closures = json.at("solutions"),
                                               .least_fraction = json.at("least_fraction"),
                                               .greatest_fraction = json.at("greatest_fraction")};
  if (!json.at("part").is_null())
    group.part = compare::name(compare::parse_approximations(json.at("part").get<std::string>()));
  const bool known = std::ranges::all_of(group.closures, [&](const std::string& id) {
    return std::ranges::find(budget, id, &ErrorBudgetRow::solution) != budget.end();
  });
  if (!known || group.closures.empty())
    throw InputError("\"limiting_errors\" has other solutions than \"budget\"; run again");
  return group;
}

// Reads the assessment of a case and requires exactly the solutions of the case, in their order.
compare::SolutionsAssessment assessment_from_json(const Json& json, const CaseResult& case_result) {
  const auto id_in = [&](const Json& object) {
    auto id = object.at("solution").get<std::string>();
    if (case_result.find(id) == nullptr) {
      throw InputError(fmt::format("\"assessment\" has the unknown solution {}; run again",
                                   base::in_quotes(id)));
    }
    return id;
  };
  compare::SolutionsAssessment assessment;
  if (const Json& reference = json.at("reference"); !reference.is_null()) {
    assessment.reference = id_in(reference);
    assessment.is_reference_chosen_by_user = reference.value("selected_by", "") == "user";
    assessment.reference_y_l1 = number_or_default(kInfinity, reference.at("y_l1"));
    assessment.reference_ydot_l1 = number_or_default(kInfinity, reference.at("ydot_l1"));
  }
  if (const Json& second = json.at("confirmation"); !second.is_null())
    assessment.confirmation = {id_in(second), second.at("agrees")};
  for (const auto& solution : json.at("solutions")) {
    const auto agreement = base::enum_from_name<compare::AgreementWithReference>(
        solution.at("agreement").get<std::string>());
    if (!agreement) throw InputError("\"assessment\" has an unknown agreement; run again");
    assessment.solutions.push_back({.id = id_in(solution),
                                    .agreement = *agreement,
                                    .y = optional_number_at_key(solution, "y_l1"),
                                    .ydot = optional_number_at_key(solution, "ydot_l1"),
                                    .rank = {}});
    if (!solution.at("rank").is_null())
      assessment.solutions.back().rank = integer_at_key(solution, "rank");
  }
  if (!std::ranges::equal(assessment.solutions, case_result.solutions, {},
                          &compare::SolutionAssessment::id, &transform::Solution::id)) {
    throw InputError("\"assessment\" has other solutions than \"solutions\"; run again");
  }
  for (const auto& group : json.at("limiting_errors")) {
    assessment.limiting_errors.groups.push_back(
        limiting_error_from_json(group, case_result.budget));
  }
  assessment.limiting_errors.has_reference_disagreement = json.at("reference_disagreement");
  return assessment;
}

CaseResult case_from_json(const Json& json) {
  CaseResult case_result{.problem = problem_from_json(json)};
  std::set<std::string> ids;
  for (const auto& solution : json.at("solutions")) {
    case_result.solutions.push_back(solution_from_json(solution));
    if (!ids.insert(case_result.solutions.back().id()).second) {
      throw InputError(base::to_printable_text(case_result.solutions.back().id()) +
                       " occurs twice; run again");
    }
  }
  for (const auto& pair : json.at("comparisons"))
    case_result.pairs.push_back(pair_distances_from_json(pair));
  if (json.contains("budget")) {
    for (const auto& row : json.at("budget"))
      case_result.budget.push_back(budget_row_from_json(row));
  }
  if (json.contains("bounds")) case_result.bounds = bounds_from_json(json.at("bounds"));
  if (json.contains("own_errors")) {
    for (const auto& own : json.at("own_errors")) {
      case_result.moment_error_estimates.push_back({own.at("solution"),
                                                    moments_from_json(own.at("corrected")),
                                                    moments_from_json(own.at("error"))});
    }
  }
  if (json.contains("assessment")) {
    case_result.assessment = assessment_from_json(json.at("assessment"), case_result);
  } else {
    case_result.update_assessment();  // runs of older program versions have no assessment
  }
  return case_result;
}

void require_summary_schema(const Json& json, const std::string& file_name) {
  if (!json.is_object() || !json.contains("schema")) {
    throw InputError(
        fmt::format("{} is not the summary of a run: \"schema\" is missing", file_name));
  }
  if (json.at("schema") != kSummarySchema) {
    throw InputError(fmt::format("{} has schema {}, but this program reads schema {}; run again",
                                 file_name, base::to_printable_text(json.at("schema").dump()),
                                 kSummarySchema));
  }
}

}  // namespace

std::string run_summary_text(const Run& run, std::span<const FileChecksum> files) {
  Json json{{"schema", kSummarySchema}, {"program", program_to_json(run.program)}};
  if (!run.stopped.empty()) json["stopped"] = run.stopped;
  json["cases"] = list_to_json(run.cases, case_json);
  for (const auto& [file, crc32] : files) json["files"][file] = crc32;
  return serialise_json(replace_non_finite_by_null(std::move(json)));
}

Run read_run_summary(std::istream& in, const std::string& file_name) {
  const Json json = parse_json(in, file_name);
  require_summary_schema(json, file_name);
  try {
    const Json& program = json.at("program");
    Run run{{program.at("name"), program.at("version"), program.at("command")},
            {},
            json.value("stopped", std::string())};
    std::set<std::string> names;
    for (const auto& case_result : json.at("cases")) {
      const auto name = case_result.at("name").get<std::string>();
      if (!names.insert(name).second) {
        throw InputError(base::to_printable_text(name) + " occurs twice; run again");
      }
      try {
        run.cases.push_back(case_from_json(case_result));
      } catch (const InputError& error) {
        throw InputError(fmt::format("{}: {}", base::to_printable_text(name), error.what()));
      }
    }
    if (json.contains("files")) {
      for (const auto& [file, crc32] : json.at("files").items()) run.files.push_back({file, crc32});
    }
    return run;
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", file_name, error.what()));
  } catch (const Json::exception& error) {
    throw InputError(fmt::format("{} is not a complete summary: {}; run again", file_name,
                                 json_error_message(error)));
  }
}

}  // namespace fpkcheck::results
