#include "compare/summary.hpp"

#include <cmath>
#include <stdexcept>

#include "compare/budget/budget.hpp"
#include "compare/budget/limits.hpp"
#include "problem/saved_fields.hpp"

namespace fpkcheck::compare {
namespace {

using Json = nlohmann::ordered_json;

Json system_of(const problem::System& system) {
  return {{"damping", system.damping()},
          {"stiffness", system.stiffness()},
          {"cubic", system.cubic()},
          {"restitution", system.restitution()}};
}

Json impulse_of(const problem::ImpulseTrain& impulses) {
  return {{"rate", impulses.arrival_rate()},
          {"law", impulses.law().name()},
          {"intensity", impulses.intensity()},
          {"mean", impulses.law().moment(1)},
          {"moments", impulses.law().moments()}};
}

Json moments_of(const transform::Moments& m) {
  return {{"y1", m.y1}, {"y2", m.y2}, {"y4", m.y4}, {"v1", m.v1}, {"v2", m.v2}, {"v4", m.v4}};
}

Json solution_of(const Entry& entry) {
  const auto& s = entry.solution;
  Json json{{"id", s.id},
            {"method", s.method},
            {"equation", s.equation},
            {"impact", s.method == "file" ? "-" : problem::name(s.impact)},  // others solved it
            {"options", entry.options.is_null() ? Json::object() : entry.options},
            {"status", transform::name(s.status)},
            {"reason", s.reason},
            {"seconds", s.seconds},
            {"moments", nullptr},
            {"mass", nullptr},
            {"min_density", nullptr},
            {"energy_residual", nullptr}};
  if (s.density || !s.estimated_marginals.empty()) {
    json["moments"] = moments_of(s.moments);
    json["mass"] = s.mass;
    json["min_density"] = s.min_density;
    json["energy_residual"] = s.energy_residual;
  }
  if (!entry.details.is_null() && !entry.details.is_object()) {
    throw std::logic_error("the details of " + s.id + " are not an object");
  }
  for (const auto& [key, value] : entry.details.items()) {
    if (json.contains(key)) throw std::logic_error("the details of " + s.id + " claim " + key);
    json[key] = value;
  }
  return json;
}

Json comparison_of(const Comparison& comparison) {
  const Distances& d = comparison.distances;
  Json tail = Json::array();
  for (const auto& part : d.log10_tail) {
    tail.push_back({{"from", part.from},
                    {"to", part.to},
                    {"mean_abs", part.mean_abs},
                    {"bins", part.bins},
                    {"left_out", part.left_out}});
  }
  return {{"a", comparison.a},
          {"b", comparison.b},
          {"variable", transform::name(comparison.variable)},
          {"l1", d.l1},
          {"l2", d.l2},
          {"sup", d.sup},
          {"hellinger", d.hellinger},
          {"kl", d.kl},
          {"log10_tail", tail}};
}

Json case_of(const CaseReport& report) {
  Json solutions = Json::array(), comparisons = Json::array();
  for (const auto& entry : report.entries) solutions.push_back(solution_of(entry));
  for (const auto& c : report.comparisons) comparisons.push_back(comparison_of(c));
  Json json = case_json(report.problem);
  json["solutions"] = solutions;
  json["comparisons"] = comparisons;
  json["budget"] = to_json(error_budget(report));
  json["limits"] = limits(json);
  return json;
}

}  // namespace

std::string program_version() { return FPKCHECK_VERSION; }

Json program_json(const std::string& command) {
  return {{"name", "fpkcheck"}, {"version", program_version()}, {"command", command}};
}

Json case_json(const problem::Problem& problem) {
  return {{"name", problem.name},
          {"system", system_of(problem.system)},
          {"impulse", impulse_of(problem.impulses)}};
}

problem::Problem problem_from_json(const Json& summary_case) {
  problem::SavedFields system(summary_case.at("system"), "system");
  problem::SavedFields impulse(summary_case.at("impulse"), "impulse");
  impulse.pass_over("moments");  // follow from the others
  problem::Problem problem{summary_case.at("name").get<std::string>(),
                           problem::System({.damping = system.number("damping"),
                                            .stiffness = system.number("stiffness"),
                                            .cubic = system.number("cubic"),
                                            .restitution = system.number("restitution")}),
                           problem::ImpulseTrain({.arrival_rate = impulse.number("rate"),
                                                  .law = impulse.text("law"),
                                                  .intensity = impulse.number("intensity"),
                                                  .mean = impulse.number("mean")})};
  system.require_all_read();
  impulse.require_all_read();
  return problem;
}

Json with_null_for_non_finite(Json value) {
  if (value.is_number_float() && !std::isfinite(value.get<double>())) return nullptr;
  if (value.is_structured()) {
    for (auto& element : value) element = with_null_for_non_finite(std::move(element));
  }
  return value;
}

Json summary(const std::string& command, std::span<const CaseReport> cases) {
  Json json{
      {"schema", kSummarySchema}, {"program", program_json(command)}, {"cases", Json::array()}};
  for (const auto& report : cases) json["cases"].push_back(case_of(report));
  return with_null_for_non_finite(std::move(json));
}

}  // namespace fpkcheck::compare
