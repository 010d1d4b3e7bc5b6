#include <nlohmann/json.hpp>

#include "mcs/simulate.hpp"

namespace fpkcheck::mcs {

nlohmann::ordered_json to_json(const Summary& summary) {
  const transform::Moments& errors = summary.standard_errors.moments;
  return {{"time", summary.time},
          {"samples", summary.samples},
          {"effective_samples", summary.effective_samples},
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
          {"sampling_l1", {{"y", summary.sampling_l1_y}, {"ydot", summary.sampling_l1_ydot}}},
          {"variance_reduction",
           {{"y2", summary.variance_reduction_y2}, {"v2", summary.variance_reduction_v2}}},
          {"outside", summary.outside},
          {"seed", summary.seed},
          {"threads", summary.threads},
          {"streams", summary.streams},
          {"step", summary.step},
          {"sampling_interval", summary.sampling_interval},
          {"burn_in", summary.burn_in},
          {"impact_rate", summary.impact_rate},
          {"impulses", summary.impulses}};
}

nlohmann::ordered_json to_json(const Options& options) {
  const auto or_null = [](auto value) {
    return value == 0 ? nlohmann::ordered_json() : nlohmann::ordered_json(value);
  };
  return {{"time", or_null(options.time)},
          {"seed", options.seed},
          {"threads", or_null(options.threads)},
          {"streams", options.streams},
          {"step", or_null(options.step)}};
}

}  // namespace fpkcheck::mcs
