#include <nlohmann/json.hpp>

#include "mcs/simulate.hpp"

#include "mcs/stream.hpp"
#include "problem/saved_fields.hpp"

namespace fpkcheck::mcs {

static std::string_view name(Equation equation) {
  return equation == Equation::white ? "white" : "kf";
}

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
  return {{"equation", name(options.equation)},
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

Options options_from_json(const nlohmann::ordered_json& json) {
  problem::SavedFields saved(json, "options");
  const Options options{.equation = saved.choice("equation", {Equation::kf, Equation::white}),
                        .time = saved.number_or_null("time").value_or(0),
                        .samples = saved.number_or_null("samples").value_or(0),
                        .target_error = saved.number_or_null("target_error").value_or(0),
                        .seed = saved.count("seed"),
                        .threads = saved.integer_or_null("threads").value_or(0),
                        .streams = saved.integer("streams"),
                        .step = saved.number_or_null("step").value_or(0),
                        .white_step = saved.number_or_null("white_step").value_or(0),
                        .tails = saved.flag("tails")};
  saved.require_all_read();
  return options;
}

}  // namespace fpkcheck::mcs
