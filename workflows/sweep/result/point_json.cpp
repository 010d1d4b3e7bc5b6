#include "workflows/sweep/result/point_json.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/input_error.hpp"
#include "base/text/sanitise.hpp"

namespace fpkcheck::sweep {
namespace {

using results::Json;
using transform::Moments;

Json pair_json(const MarginalL1Pair& pair) { return {pair.y, pair.ydot}; }

MarginalL1Pair pair_from_json(const Json& json) {
  const auto number = [&](std::size_t k) {
    const Json& value = json.at(k);
    return value.is_null() ? results::kNotANumber : value.get<double>();
  };
  return {number(0), number(1)};
}

Json method_json(const MethodResult& result) {
  Json json{{"status", name(result.status)}, {"seconds", result.seconds}};
  if (!result.reason.empty()) json["reason"] = result.reason;
  if (result.moments) {
    json["moments"] = Json::array();
    for (const auto& moment : transform::kMoments) {
      json["moments"].push_back((*result.moments).*moment.moment);
    }
  }
  if (result.l1) json["l1"] = pair_json(*result.l1);
  if (result.error) json["error"] = pair_json(*result.error);
  for (const auto& share : result.budget) json["budget"][share.part] = pair_json(share.l1);
  return json;
}

MethodResult method_from_json(const Json& json) {
  const auto text = json.at("status").get<std::string>();
  const auto status = base::enum_from_name<transform::Status>(text);
  if (!status) throw InputError(fmt::format("status {} is unknown", base::in_quotes(text)));
  MethodResult result{.status = *status, .seconds = json.at("seconds")};
  if (json.contains("reason")) result.reason = json.at("reason");
  if (json.contains("moments")) {
    result.moments.emplace();
    std::size_t k = 0;
    for (const auto& moment : transform::kMoments) {
      const Json& value = json.at("moments").at(k++);
      (*result.moments).*moment.moment =
          value.is_null() ? results::kNotANumber : value.get<double>();
    }
  }
  if (json.contains("l1")) result.l1 = pair_from_json(json.at("l1"));
  if (json.contains("error")) result.error = pair_from_json(json.at("error"));
  if (json.contains("budget")) {
    for (const auto& [part, l1] : json.at("budget").items()) {
      result.budget.push_back({part, pair_from_json(l1)});
    }
  }
  return result;
}

}  // namespace

Json point_json(const PointResult& result) {
  Json json{{"point", result.point},
            {"seconds", result.seconds},
            {"reference", result.reference},
            {"methods", Json::array()}};
  for (const auto& method : result.methods) json["methods"].push_back(method_json(method));
  return json;
}

std::string journal_line(const PointResult& result) {
  return results::with_null_for_non_finite(point_json(result))
      .dump(-1, ' ', false, Json::error_handler_t::replace);
}

PointResult point_from_json(const Json& json) {
  PointResult result{.point = json.at("point").get<std::size_t>(),
                     .seconds = json.value("seconds", 0.0),
                     .reference = json.at("reference")};
  for (const auto& method : json.at("methods")) {
    result.methods.push_back(method_from_json(method));
    if (!json.contains("seconds")) result.seconds += result.methods.back().seconds;
  }
  return result;
}

}  // namespace fpkcheck::sweep
