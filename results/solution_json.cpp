#include "results/json_conversions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>
#include <stdexcept>
#include <string_view>

#include "base/input_error.hpp"
#include "base/text/printable_text.hpp"

namespace fpkcheck::results {
namespace {

using problem::DensityEquation;
using problem::ImpactCondition;
using transform::Moments;
using transform::Solution;
using transform::SolutionIdentity;

// Texts for the unknown density equation and impact condition of an external density.
constexpr const char* kUnknownEquation = "given";
constexpr const char* kUnknownImpact = "-";

// Keys of a solution in JSON that all solvers share. All other keys of a solution in JSON are
// metrics of its solver.
constexpr std::string_view kCommonKeys[] = {"id",
                                            "method",
                                            "equation",
                                            "impact",
                                            "identity",
                                            "options",
                                            "status",
                                            "reason",
                                            "seconds",
                                            "moments",
                                            "mass",
                                            "atoms",
                                            "min_density",
                                            "energy_residual",
                                            "standard_errors",
                                            "sampling_l1",
                                            "smooth_sampling_l1"};
// Keys of the JSON object "error" that all solvers share. All other keys of the JSON object "error"
// are metrics of the solver.
constexpr std::string_view kCommonErrorKeys[] = {"y_l1", "ydot_l1", "moments"};

bool contains_key(std::span<const std::string_view> keys, std::string_view key) {
  return std::ranges::find(keys, key) != keys.end();
}

Json identity_json(const SolutionIdentity& identity) {
  const auto& plot_style = identity.plot_style;
  return {{"role", name(identity.role)},
          {"family", identity.family},
          {"formulation", identity.formulation},
          {"order", identity.order ? Json(*identity.order) : Json()},
          {"meaning", identity.meaning},
          {"trust", identity.trust},
          {"look",
           {{"colour", plot_style.colour},
            {"dash", plot_style.dash},
            {"width", plot_style.width},
            {"as_points", plot_style.as_points},
            {"layer", plot_style.layer},
            {"symbol", plot_style.symbol}}}};
}

void read_solution_identity(const Json& json, SolutionIdentity& identity) {
  const auto role =
      base::enum_from_name<transform::SolutionRole>(json.at("role").get<std::string>());
  if (!role)
    throw InputError(
        fmt::format("unknown role {}; run again", base::to_printable_text(json.at("role").dump())));
  identity.role = *role;
  identity.family = json.at("family");
  identity.formulation = json.at("formulation");
  if (!json.at("order").is_null()) identity.order = integer_at_key(json, "order");
  identity.meaning = json.at("meaning");
  identity.trust = integer_at_key(json, "trust");
  const Json& plot_style = json.at("look");
  identity.plot_style = {.colour = plot_style.at("colour"),
                         .dash = plot_style.at("dash"),
                         .width = plot_style.at("width"),
                         .as_points = plot_style.at("as_points"),
                         .layer = integer_at_key(plot_style, "layer"),
                         .symbol = plot_style.at("symbol")};
}

Json atoms_json(const std::vector<transform::RestAtom>& atoms) {
  Json json = Json::array();
  for (const auto& atom : atoms) {
    json.push_back({{"y", atom.y}, {"probability", atom.probability}});
    if (atom.standard_error) json.back()["standard_error"] = *atom.standard_error;
    if (atom.error_estimate) json.back()["stated_error"] = *atom.error_estimate;
  }
  return json;
}

std::vector<transform::RestAtom> atoms_from_json(const Json& json) {
  std::vector<transform::RestAtom> atoms;
  for (const Json& atom : json) {
    atoms.push_back({.y = number_at_key(atom, "y"),
                     .probability = number_at_key(atom, "probability"),
                     .standard_error = optional_number_at_key(atom, "standard_error"),
                     .error_estimate = optional_number_at_key(atom, "stated_error")});
  }
  return atoms;
}

Json sampling_error_json(const transform::MarginalSamplingErrors& sampling) {
  Json json = Json::object();
  const auto put = [&](const char* key, const std::optional<double>& value) {
    if (value) json[key] = *value;
  };
  put("y", sampling.y);
  put("ydot", sampling.ydot);
  put("y_99", sampling.y_99);
  put("ydot_99", sampling.ydot_99);
  return json;
}

std::optional<transform::MarginalSamplingErrors> sampling_error_from_json(const Json& json,
                                                                          const char* key) {
  const auto sampling = json.find(key);
  if (sampling == json.end()) return std::nullopt;
  return transform::MarginalSamplingErrors{.y = optional_number_at_key(*sampling, "y"),
                                           .ydot = optional_number_at_key(*sampling, "ydot"),
                                           .y_99 = optional_number_at_key(*sampling, "y_99"),
                                           .ydot_99 = optional_number_at_key(*sampling, "ydot_99")};
}

template <class Enum>
std::optional<Enum> enumerator_from_json(const Json& json, const char* key,
                                         std::string_view unknown) {
  const auto text = json.at(key).get<std::string>();
  if (text == unknown) return std::nullopt;
  const auto value = base::enum_from_name<Enum>(text);
  if (!value)
    throw InputError(fmt::format("{} {} is unknown; run again", key, base::in_quotes(text)));
  return value;
}

void read_solution_numbers(const Json& json, Solution& s) {
  s.had_density = !json.at("mass").is_null();
  if (s.had_density) {
    s.moments = moments_from_json(json.at("moments"));
    s.mass = number_at_key(json, "mass");
    if (json.contains("atoms")) s.atoms = atoms_from_json(json.at("atoms"));
    s.min_density = number_at_key(json, "min_density");
    s.energy_residual = number_at_key(json, "energy_residual");
  }
  if (const auto errors = json.find("standard_errors"); errors != json.end()) {
    s.standard_errors = {moments_from_json(*errors), number_at_key(*errors, "energy_residual")};
  }
  s.sampling = sampling_error_from_json(json, "sampling_l1");
  s.smooth_sampling = sampling_error_from_json(json, "smooth_sampling_l1");
  if (const auto error = json.find("error"); error != json.end() && error->is_object()) {
    s.error = {number_at_key(*error, "y_l1"), number_at_key(*error, "ydot_l1"),
               moments_from_json(error->at("moments"))};
  }
}

// Returns the metrics of the solver from the JSON object of a solution.
Json solver_metrics_part(const Json& json) {
  Json rest = Json::object();
  for (const auto& [key, value] : json.items()) {
    if (contains_key(kCommonKeys, key)) continue;
    if (key != "error") {
      rest[key] = value;
      continue;
    }
    for (const auto& [leaf, of_error] : value.items()) {
      if (!contains_key(kCommonErrorKeys, leaf)) rest["error"][leaf] = of_error;
    }
  }
  return rest;
}

}  // namespace

Json solution_json(const Solution& s) {
  const SolutionIdentity& identity = s.identity;
  Json json{{"id", identity.id},
            {"method", identity.method},
            {"equation", identity.equation ? name(*identity.equation) : kUnknownEquation},
            {"impact", identity.impact ? name(*identity.impact) : kUnknownImpact},
            {"identity", identity_json(identity)},
            {"options", values_to_json(s.options)},
            {"status", name(s.status)},
            {"reason", s.reason},
            {"seconds", s.seconds},
            {"moments", nullptr},
            {"mass", nullptr},
            {"min_density", nullptr},
            {"energy_residual", nullptr}};
  if (s.has_density()) {
    json["moments"] = moments_to_json(s.moments);
    json["mass"] = s.mass;
    if (!s.atoms.empty()) json["atoms"] = atoms_json(s.atoms);
    json["min_density"] = s.min_density;
    json["energy_residual"] = s.energy_residual;
  }
  if (s.standard_errors) {
    json["standard_errors"] = moments_to_json(s.standard_errors->moments);
    json["standard_errors"]["energy_residual"] = s.standard_errors->energy_residual;
  }
  if (s.sampling) json["sampling_l1"] = sampling_error_json(*s.sampling);
  if (s.smooth_sampling) json["smooth_sampling_l1"] = sampling_error_json(*s.smooth_sampling);
  if (s.error) {
    json["error"] = {{"y_l1", s.error->y_l1},
                     {"ydot_l1", s.error->ydot_l1},
                     {"moments", moments_to_json(s.error->moments)}};
  }
  for (const auto& observation : s.metrics) {
    const std::string_view path = observation.path;
    if (contains_key(kCommonKeys, path.substr(0, path.find_first_of(".[")))) {
      throw std::logic_error("a metric of " + s.id() + " has the reserved key " + observation.path);
    }
  }
  add_metrics(s.metrics, json);
  return json;
}

Solution solution_from_json(const Json& json) {
  Solution s;
  SolutionIdentity& identity = s.identity;
  identity.id = json.at("id");
  identity.method = json.at("method");
  identity.equation = enumerator_from_json<DensityEquation>(json, "equation", kUnknownEquation);
  identity.impact = enumerator_from_json<ImpactCondition>(json, "impact", kUnknownImpact);
  if (json.contains("identity")) read_solution_identity(json.at("identity"), identity);
  s.options = values_from_json(json.at("options"));
  const auto status = enumerator_from_json<transform::Status>(json, "status", "");
  if (!status) throw InputError("the status is empty; run again");
  s.status = *status;
  s.reason = json.at("reason");
  s.seconds = number_at_key(json, "seconds");
  read_solution_numbers(json, s);
  s.metrics = metrics_from_json(solver_metrics_part(json));
  return s;
}

}  // namespace fpkcheck::results
