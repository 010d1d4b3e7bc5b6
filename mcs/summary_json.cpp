#include <nlohmann/json.hpp>

#include "mcs/simulate.hpp"

#include "mcs/stream.hpp"

namespace fpkcheck::mcs {
namespace {

using Json = nlohmann::ordered_json;

Json joint_moments(const std::vector<Estimate>& estimates) {
  Json list = Json::array();
  for (std::size_t n = 0; n < estimates.size(); ++n) {
    list.push_back({{"y", kPowers[n].first},
                    {"v", kPowers[n].second},
                    {"mean", estimates[n].mean},
                    {"standard_error", estimates[n].standard_error}});
  }
  return list;
}

Json quantiles(const std::vector<Quantile>& quantiles) {
  Json list = Json::array();
  for (const Quantile& q : quantiles) {
    list.push_back({{"probability", q.probability},
                    {"value", q.value},
                    {"lower", q.lower},
                    {"upper", q.upper}});
  }
  return list;
}

Json rates(const std::vector<LevelRate>& rates) {
  Json list = Json::array();
  for (const LevelRate& r : rates) {
    list.push_back(
        {{"level", r.level}, {"rate", r.rate.mean}, {"standard_error", r.rate.standard_error}});
  }
  return list;
}

}  // namespace

nlohmann::ordered_json to_json(const Summary& summary) {
  const transform::Moments& errors = summary.standard_errors.moments;
  return {{"time", summary.time},
          {"samples", summary.samples},
          {"effective_samples", summary.effective_samples},
          {"effective_samples_y2", summary.effective_samples_y2},
          {"standard_errors",
           {{"y1", errors.y1},
            {"y2", errors.y2},
            {"y4", errors.y4},
            {"v1", errors.v1},
            {"v2", errors.v2},
            {"v4", errors.v4},
            {"energy_residual", summary.standard_errors.energy_residual}}},
          {"excess_power",
           {{"relative", summary.excess_power}, {"standard_error", summary.excess_power_error}}},
          {"sampling_l1",
           {{"y", summary.sampling_l1_y},
            {"ydot", summary.sampling_l1_ydot},
            {"y_99", summary.sampling_l1_y_99},
            {"ydot_99", summary.sampling_l1_ydot_99}}},
          {"variance_reduction",
           {{"y2", summary.variance_reduction_y2}, {"v2", summary.variance_reduction_v2}}},
          {"outside", summary.outside},
          {"seed", summary.seed},
          {"threads", summary.threads},
          {"streams", summary.streams},
          {"step", summary.step},
          {"sampling_interval", summary.sampling_interval},
          {"burn_in", summary.burn_in},
          {"impact_rate", summary.impact_rate.mean},
          {"impact_rate_error", summary.impact_rate.standard_error},
          {"impulses", summary.impulses},
          {"flights", summary.flights},
          {"rounds", summary.rounds},
          {"interrupted", summary.interrupted},
          {"kick_interval", summary.kick_interval > 0 ? Json(summary.kick_interval) : Json()},
          {"joint_moments", joint_moments(summary.joint_moments)},
          {"quantiles",
           {{"y", quantiles(summary.y_quantiles)}, {"ydot", quantiles(summary.v_quantiles)}}},
          {"upcrossings", rates(summary.crossings)},
          {"peaks", rates(summary.peaks)},
          {"splitting_thresholds", summary.thresholds}};
}

nlohmann::ordered_json to_json(const Options& options) {
  const auto or_null = [](auto value) { return value == 0 ? Json() : Json(value); };
  return {{"equation", options.equation == Equation::white ? "white" : "kf"},
          {"time", or_null(options.time)},
          {"samples", or_null(options.samples)},
          {"target_error", or_null(options.target_error)},
          {"seed", options.seed},
          {"threads", or_null(options.threads)},
          {"streams", options.streams},
          {"step", or_null(options.step)},
          {"white_step", or_null(options.white_step)},
          {"tails", options.tails}};
}

}  // namespace fpkcheck::mcs
