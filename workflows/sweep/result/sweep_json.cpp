#include "workflows/sweep/result/sweep_json.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/input_error.hpp"
#include "base/text/printable_text.hpp"
#include "results/json_conversions.hpp"
#include "workflows/sweep/result/sweep_results.hpp"

namespace fpkcheck::sweep {
namespace {

using results::Json;
using transform::Moments;

Json axis_json(const SweepAxis& axis) {
  Json json{{"key", axis.key}, {"spacing", name(axis.spacing)}};
  if (axis.spacing != SweepAxisSpacing::listed) {
    json["from"] = axis.from;
    json["to"] = axis.to;
  }
  json["values"] = Json::array();
  for (const auto& value : axis.values) json["values"].push_back(results::value_to_json(value));
  return json;
}

template <class Enum>
Enum enum_from_json(const Json& json) {
  const auto text = json.get<std::string>();
  const auto value = base::enum_from_name<Enum>(text);
  if (!value) throw InputError(fmt::format("{} is unknown", base::in_quotes(text)));
  return *value;
}

// JSON does not distinguish 1 from 1.0, but all numeric values of varied keys are doubles.
base::Value integer_to_double(base::Value value) {
  const auto* whole = std::get_if<std::int64_t>(&value);
  return whole == nullptr ? value : static_cast<double>(*whole);
}

SweepAxis axis_from_json(const Json& json) {
  SweepAxis axis{.key = json.at("key"),
                 .spacing = enum_from_json<SweepAxisSpacing>(json.at("spacing"))};
  if (axis.spacing != SweepAxisSpacing::listed) {
    axis.from = json.at("from");
    axis.to = json.at("to");
  }
  for (const auto& value : json.at("values")) {
    axis.values.push_back(integer_to_double(results::value_from_json(value)));
  }
  return axis;
}

methods::Method method_from_json(const Json& json, const methods::SolverRegistry& registry) {
  const auto solver = json.at("method").get<std::string>();
  const auto* found = registry.find_solver(solver);
  if (found == nullptr) {
    throw InputError(fmt::format("solver {} is unknown", base::in_quotes(solver)));
  }
  return registry.make_method(*found, results::values_from_json(json.at("options")));
}

Json marginal_pair_json(const MarginalL1Values& pair) { return {pair.y, pair.ydot}; }

double number_from_json(const Json& json) {
  return json.is_null() ? results::kNotANumber : json.get<double>();
}

MarginalL1Values marginal_pair_from_json(const Json& json) {
  return {number_from_json(json.at(0)), number_from_json(json.at(1))};
}

Json method_result_json(const SweepMethodResult& result) {
  Json json{{"status", name(result.status)}, {"seconds", result.seconds}};
  if (!result.reason.empty()) json["reason"] = result.reason;
  if (result.moments) {
    json["moments"] = Json::array();
    for (const auto& moment : transform::kMoments) {
      json["moments"].push_back((*result.moments).*moment.moment);
    }
  }
  if (result.l1) json["l1"] = marginal_pair_json(*result.l1);
  if (result.error) json["error"] = marginal_pair_json(*result.error);
  for (const auto& share : result.budget) json["budget"][share.part] = marginal_pair_json(share.l1);
  for (const auto& slopes : result.slopes) {
    json["slopes"][slopes.key] = {{"y2", slopes.y2},
                                  {"v2", slopes.v2},
                                  {"error", {{"y2", slopes.y2_error}, {"v2", slopes.v2_error}}}};
  }
  return json;
}

SweepMethodResult method_result_from_json(const Json& json) {
  const auto text = json.at("status").get<std::string>();
  const auto status = base::enum_from_name<transform::Status>(text);
  if (!status) throw InputError(fmt::format("status {} is unknown", base::in_quotes(text)));
  SweepMethodResult result{.status = *status, .seconds = json.at("seconds")};
  if (json.contains("reason")) result.reason = json.at("reason");
  if (json.contains("moments")) {
    result.moments.emplace();
    std::size_t k = 0;
    for (const auto& moment : transform::kMoments) {
      (*result.moments).*moment.moment = number_from_json(json.at("moments").at(k++));
    }
  }
  if (json.contains("l1")) result.l1 = marginal_pair_from_json(json.at("l1"));
  if (json.contains("error")) result.error = marginal_pair_from_json(json.at("error"));
  if (json.contains("budget")) {
    for (const auto& [part, l1] : json.at("budget").items()) {
      result.budget.push_back({part, marginal_pair_from_json(l1)});
    }
  }
  if (json.contains("slopes")) {
    for (const auto& [key, slopes] : json.at("slopes").items()) {
      const Json& error = slopes.at("error");
      result.slopes.push_back({.key = key,
                               .y2 = number_from_json(slopes.at("y2")),
                               .v2 = number_from_json(slopes.at("v2")),
                               .y2_error = number_from_json(error.at("y2")),
                               .v2_error = number_from_json(error.at("v2"))});
    }
  }
  return result;
}

}  // namespace

Json sweep_plan_json(const SweepPlan& plan) {
  Json json{{"case", results::problem_to_json(plan.base)},
            {"vary", Json::array()},
            {"design", name(plan.design)},
            {"points", plan.sobol_points},
            {"marginals", plan.marginals},
            {"closure_errors", name(plan.closure_errors)},
            {"methods", Json::array()}};
  if (plan.slopes) json["slopes"] = true;
  for (const auto& axis : plan.axes) json["vary"].push_back(axis_json(axis));
  for (const auto& method : plan.methods) {
    json["methods"].push_back({{"id", method.id()},
                               {"method", method.identity.method},
                               {"options", results::values_to_json(method.options)}});
  }
  return json;
}

SweepPlan sweep_plan_from_json(const Json& json, const methods::SolverRegistry& registry) {
  SweepPlan plan{.base = results::problem_from_json(json.at("case")),
                 .axes = {},
                 .design = enum_from_json<SweepPlanDesign>(json.at("design")),
                 .sobol_points = json.at("points"),
                 .marginals = json.at("marginals"),
                 .closure_errors = enum_from_json<ClosureErrorSource>(json.at("closure_errors")),
                 .slopes = json.value("slopes", false)};
  for (const auto& axis : json.at("vary")) plan.axes.push_back(axis_from_json(axis));
  for (const auto& method : json.at("methods")) {
    plan.methods.push_back(method_from_json(method, registry));
  }
  plan.points = make_sweep_plan_points(plan.axes, plan.design, plan.sobol_points);
  return plan;
}

std::string first_sweep_plan_difference(const Json& before, const Json& now) {
  const Json patch = Json::diff(before, now);
  if (patch.empty()) return "";
  const Json& first = patch.front();
  const auto place = first.at("path").get<std::string>();
  const Json::json_pointer path(place);
  return fmt::format(
      "{}: {} then, {} now", base::to_printable_text(place),
      before.contains(path) ? base::to_printable_text(before.at(path).dump()) : "nothing",
      first.contains("value") ? base::to_printable_text(first.at("value").dump()) : "nothing");
}

Json point_result_json(const SweepPointResult& result) {
  Json json{{"point", result.point},
            {"seconds", result.seconds},
            {"reference", result.reference},
            {"methods", Json::array()}};
  for (const auto& method : result.methods) json["methods"].push_back(method_result_json(method));
  return json;
}

std::string sweep_journal_line(const SweepPointResult& result) {
  return results::replace_non_finite_by_null(point_result_json(result))
      .dump(-1, ' ', false, Json::error_handler_t::replace);
}

SweepPointResult point_result_from_json(const Json& json) {
  SweepPointResult result{.point = json.at("point").get<std::size_t>(),
                          .seconds = json.value("seconds", 0.0),
                          .reference = json.at("reference")};
  for (const auto& method : json.at("methods")) {
    result.methods.push_back(method_result_from_json(method));
    if (!json.contains("seconds")) result.seconds += result.methods.back().seconds;
  }
  return result;
}

std::string sweep_json_text(const SweepResults& results, const std::string& command) {
  using results::Json;
  constexpr int kSchema = 1;
  Json json{{"schema", kSchema},
            {"program", results::program_to_json(results::current_program(command))},
            {"plan", sweep_plan_json(results.plan)},
            {"points", Json::array()}};
  for (const auto& point : results.points) {
    Json one = point_result_json(point);
    one["at"] = Json::object();
    for (std::size_t a = 0; a < results.plan.axes.size(); ++a) {
      one["at"][results.plan.axes[a].key] =
          results::value_to_json(results.plan.points[point.point][a]);
    }
    json["points"].push_back(std::move(one));
  }
  return results::serialise_json(json);
}

}  // namespace fpkcheck::sweep
