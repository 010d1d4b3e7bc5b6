#include "mcs/summary.hpp"

#include <fmt/format.h>

#include "mcs/streams/stream.hpp"

namespace fpkcheck::mcs {
namespace {

using transform::counted;
using transform::Kind;
using transform::Observer;

/// Adds a value and its standard error.
void observe(Observer& observer, const std::string& path, const Estimate& estimate,
             const std::string& error_path) {
  observer.add({.path = path, .value = estimate.mean, .error_at = error_path});
  observer.error(error_path, estimate.standard_error);
}

/// Adds the items of a list, each by `put(path of the item, item, index)`.
template <class Item, class Put>
void observe_list(Observer& observer, const std::string& path, const std::vector<Item>& items,
                  Kind kind, Put put) {
  if (items.empty()) observer.empty_list(path, kind);
  for (std::size_t k = 0; k < items.size(); ++k) put(fmt::format("{}[{}]", path, k), items[k], k);
}

void observe_moments(Observer& observer, const std::vector<Estimate>& moments) {
  observe_list(observer, "joint_moments", moments, Kind::result,
               [&](const std::string& at, const Estimate& moment, std::size_t k) {
                 observer.result(at + ".y", counted(kPowers[k].first));
                 observer.result(at + ".v", counted(kPowers[k].second));
                 observe(observer, at + ".mean", moment, at + ".standard_error");
               });
}

void observe_quantiles(Observer& observer, const std::string& path,
                       const std::vector<Quantile>& quantiles) {
  observe_list(observer, path, quantiles, Kind::result,
               [&](const std::string& at, const Quantile& q, std::size_t) {
                 const std::string error_path = at + ".standard_error";
                 observer.result(at + ".probability", q.probability);
                 observer.add({.path = at + ".value", .value = q.value, .error_at = error_path});
                 observer.work(at + ".lower", q.lower);
                 observer.work(at + ".upper", q.upper);
                 observer.error(error_path, (q.upper - q.lower) / (2 * kNormal95));
               });
}

void observe_rates(Observer& observer, const std::string& path,
                   const std::vector<LevelRate>& rates) {
  // Below about a hundred events the standard error itself is poorly known.
  constexpr double kRare = 0.1;
  observe_list(observer, path, rates, Kind::result,
               [&](const std::string& at, const LevelRate& r, std::size_t) {
                 observer.result(at + ".level", r.level);
                 const std::string error_path = at + ".standard_error";
                 observer.add({.path = at + ".rate",
                               .value = r.rate.mean,
                               .error_at = error_path,
                               .delicate = r.rate.standard_error > kRare * r.rate.mean});
                 observer.error(error_path, r.rate.standard_error);
               });
}

}  // namespace

transform::Observations observations(const Summary& summary) {
  Observer observer;
  observer.work("time", summary.time)
      .work("samples", counted(summary.samples))
      .error("effective_samples", summary.effective_samples)
      .error("effective_samples_y2", summary.effective_samples_y2);
  observe(observer, "excess_power.relative", {summary.excess_power, summary.excess_power_error},
          "excess_power.standard_error");
  observer.work("variance_reduction.y2", summary.variance_reduction_y2)
      .work("variance_reduction.v2", summary.variance_reduction_v2)
      .work("outside", summary.outside)
      .work("seed", counted(summary.seed))
      .work("threads", counted(summary.threads))
      .result("streams", counted(summary.streams))
      .result("step", summary.step)
      .result("sampling_interval", summary.sampling_interval)
      .result("burn_in", summary.burn_in);
  if (!summary.impacts_accumulate) {
    observe(observer, "impact_rate", summary.impact_rate, "impact_rate_error");
  }
  observe(observer, summary.balances, summary.balance_errors);
  observer.work("impulses", counted(summary.impulses))
      .work("flights", counted(summary.flights))
      .work("rounds", counted(summary.rounds))
      .result("interrupted", summary.interrupted)
      .result("kick_interval", transform::value_of(summary.kick_interval));
  observe_moments(observer, summary.joint_moments);
  observe_quantiles(observer, "quantiles.y", summary.y_quantiles);
  observe_quantiles(observer, "quantiles.ydot", summary.v_quantiles);
  observe_rates(observer, "upcrossings", summary.crossings);
  observe_rates(observer, "peaks", summary.peaks);
  observe_list(
      observer, "splitting_thresholds", summary.thresholds, Kind::work,
      [&](const std::string& at, double energy, std::size_t) { observer.work(at, energy); });
  return std::move(observer).take();
}

}  // namespace fpkcheck::mcs
