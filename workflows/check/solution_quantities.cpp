#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>

#include "workflows/check/case_quantities.hpp"
#include "workflows/check/tolerances.hpp"

namespace fpkcheck::check {
namespace {

using base::Value;
using transform::Metrics;
using transform::Solution;
using transform::SolverMetric;
using transform::SolverMetricKind;

void add_density_quantities(const Solution& s, const BaselineCheckTolerances& tolerances,
                            const SolutionPartQuantityAppender& density) {
  const auto add = [&](const char* name, CheckedQuantityKind otherwise, double number, double error,
                       double scale) {
    CheckedQuantity& quantity =
        density.append_number_quantity(name, otherwise, number, tolerances.deterministic, scale);
    if (!s.standard_errors) return;
    quantity.kind = CheckedQuantityKind::simulated;
    quantity.allowed = tolerances.standard_errors;
    quantity.error = error;
  };
  const auto errors = s.standard_errors.value_or(transform::MomentStandardErrors{});
  for (const auto& [name, symbol, moment, size] : transform::kMoments) {
    // The mean velocity E[y'] is 0 in every stationary state. Mean velocities below 1e-3 of the
    // standard deviation of y' are errors of the method, whose last digits depend on rounding.
    const double least = moment == size ? 0 : 1e-3 * std::sqrt(s.moments.*size);
    add(symbol, CheckedQuantityKind::moment, s.moments.*moment, errors.moments.*moment,
        std::max(std::abs(s.moments.*moment), least));
  }
  for (const auto& atom : s.atoms) {
    const std::string name = fmt::format("probability of rest at y = {:g}", atom.y);
    add(name.c_str(), CheckedQuantityKind::moment, atom.probability,
        atom.standard_error.value_or(0), atom.probability);
  }
  add("mass", CheckedQuantityKind::mass, s.mass, standard_error_of_mass(s), 1);
  add("energy residual", CheckedQuantityKind::energy, s.energy_residual, errors.energy_residual, 1);
  constexpr double kMinScale = 1e-6;
  density.append_number_quantity("smallest density", CheckedQuantityKind::detail, s.min_density,
                                 tolerances.deterministic,
                                 std::max(std::abs(s.min_density), kMinScale));
}

void add_error_estimates(const Solution& s, const BaselineCheckTolerances& tolerances,
                         const SolutionPartQuantityAppender& stated) {
  const auto add = [&](const std::string& of, double error, double least) {
    constexpr double kMinErrorScale = 0.1;  // default of transform::SolverMetric::min_scale
    stated.append_number_quantity("error of " + of, CheckedQuantityKind::detail, error,
                                  tolerances.deterministic,
                                  std::max({std::abs(error), least, kMinErrorScale}));
  };
  for (const auto variable : transform::kVariables) {
    add(marginal_density_symbol(variable), l1_error_of_marginal(*s.error, variable), 0);
  }
  for (const auto& [name, symbol, moment, size] : transform::kMoments) {
    // The stated error estimate of a moment contains the rounding error of the moment.
    add(symbol, s.error->moments.*moment, std::abs(s.moments.*size));
  }
}

void add_standard_error_quantities(const transform::MomentStandardErrors& errors,
                                   const SolutionPartQuantityAppender& part) {
  const auto add = [&](const std::string& of, double error) {
    part.append_number_quantity("standard error of " + of, CheckedQuantityKind::simulated_error,
                                error, 1);
  };
  for (const auto& [name, symbol, moment, size] : transform::kMoments)
    add(symbol, errors.moments.*moment);
  add("energy residual", errors.energy_residual);
}

void add_sampling_error_quantities(const transform::MarginalSamplingErrors& sampling,
                                   const SolutionPartQuantityAppender& part) {
  for (const auto variable : transform::kVariables) {
    const auto add = [&](const std::string& which, const std::optional<double>& l1) {
      part.append_number_quantity(part.name + which + marginal_density_symbol(variable),
                                  CheckedQuantityKind::simulated_error,
                                  l1.value_or(std::numeric_limits<double>::quiet_NaN()), 1);
    };
    add(" of ", expected_l1_error(sampling, variable));
    add(" in 99 of 100 of ", l1_error_quantile_99(sampling, variable));
  }
}

// Returns the part that contains a metric, e.g. "peaks[3]" for "peaks[3].rate" and "peaks" for
// "peaks[3]".
std::string parent_metric_path(const std::string& path) {
  const auto end = path.find_last_of(".[");
  return end == std::string::npos ? kWholeSolutionPart : path.substr(0, end);
}

// Returns the path of a metric without the indices of lists, e.g. "quantiles.y[].value".
std::string path_without_indices(const std::string& path) {
  std::string result;
  for (const char c : path) {
    if (c == ']' || !result.ends_with('[')) result += c;
  }
  return result;
}

class MetricQuantityAppender {
 public:
  MetricQuantityAppender(const Metrics& metrics, const BaselineCheckTolerances& tolerances,
                         const SolutionPartQuantityAppender& whole)
      : metrics_(metrics), tolerances_(tolerances), whole_(whole) {
    for (const auto& metric : metrics) {
      if (!metric.standard_error_path.empty())
        standard_error_paths_.insert(metric.standard_error_path);
      if (metric.kind == SolverMetricKind::coefficient)
        coefficient_terms_.insert(parent_metric_path(metric.path));
      const auto place = metric.path.find_last_of('[');
      if (place == std::string::npos) continue;
      auto& entries = list_entries_[metric.path.substr(0, place)];
      if (!metric.path.ends_with("[]"))
        entries.insert(metric.path.substr(0, metric.path.find(']', place)));
    }
  }

  void append_all_metrics() {
    const std::size_t first = whole_.quantities.size();
    for (const auto& metric : metrics_) {
      if (metric.kind == SolverMetricKind::coefficient) {
        const double a = finite_number_or_nan(metric.value);
        whole_.append_number_quantity(coefficient_name(metric), CheckedQuantityKind::coefficient, a,
                                      tolerances_.coefficient_tolerance(),
                                      std::max(std::abs(a), metric.min_scale));
      } else if (metric.kind == SolverMetricKind::result &&
                 !coefficient_terms_.contains(parent_metric_path(metric.path))) {
        append_result_metric(metric);
      } else if (metric.kind == SolverMetricKind::error &&
                 !standard_error_paths_.contains(metric.path)) {
        // The number of effectively independent samples is proportional to the inverse square of
        // the standard error.
        whole_.append_number_quantity(metric.path, CheckedQuantityKind::simulated_error,
                                      finite_number_or_nan(metric.value), 2);
      }
    }
    const auto own = std::span(whole_.quantities).subspan(first);
    const auto values =
        std::ranges::count(own, CheckedQuantityKind::simulated, &CheckedQuantity::kind);
    for (CheckedQuantity& quantity : own) {
      if (quantity.kind != CheckedQuantityKind::simulated) continue;
      quantity.allowed = tolerances_.bonferroni_threshold(static_cast<std::size_t>(values));
    }
  }

 private:
  // Returns the name of a coefficient, e.g. "a(4,2)" for the term x1^4 x2^2. The powers of a
  // polynomial term are the metrics of kind `result` with the parent path of the coefficient.
  std::string coefficient_name(const SolverMetric& metric) const {
    std::vector<double> powers;
    for (const auto& sibling : metrics_) {
      if (sibling.kind == SolverMetricKind::result &&
          parent_metric_path(sibling.path) == parent_metric_path(metric.path)) {
        powers.push_back(finite_number_or_nan(sibling.value));
      }
    }
    return fmt::format("{}({})", metric.path.substr(parent_metric_path(metric.path).size() + 1),
                       fmt::join(powers, ","));
  }

  // The first call of open_part() with a name appends the first quantity of the part with this
  // name.
  SolutionPartQuantityAppender open_part(const std::string& name) {
    const SolutionPartQuantityAppender result{whole_.quantities, whole_.solution, name};
    if (name != kWholeSolutionPart && opened_parts_.insert(name).second) {
      const SolutionPartQuantityAppender outer = open_part(parent_metric_path(name));
      const auto list = list_entries_.find(name);
      const std::string length =
          list == list_entries_.end() ? "there" : fmt::format("{} entries", list->second.size());
      result.begin_part(CheckedQuantityKind::detail, length, outer.name);
    }
    return result;
  }

  void append_result_metric(const SolverMetric& metric) {
    const SolutionPartQuantityAppender in = open_part(parent_metric_path(metric.path));
    const double number = finite_number_or_nan(metric.value);
    if (metric.path.ends_with("[]")) return;
    if (!metric.standard_error_path.empty()) {
      append_estimate_and_error(metric, in);
    } else if (std::holds_alternative<double>(metric.value) ||
               std::holds_alternative<std::int64_t>(metric.value)) {
      in.append_number_quantity(
          metric.path, CheckedQuantityKind::detail, number,
          metric.is_rounding_sensitive ? tolerances_.tail_tolerance() : tolerances_.deterministic,
          std::max(std::abs(number), metric.min_scale));
    } else {
      in.append_word_quantity(metric.path, metric.value);
    }
  }

  void append_estimate_and_error(const SolverMetric& metric,
                                 const SolutionPartQuantityAppender& in) {
    const SolverMetric* error = find_metric(metrics_, metric.standard_error_path);
    const double standard_error = error == nullptr ? std::numeric_limits<double>::quiet_NaN()
                                                   : finite_number_or_nan(error->value);
    in.append_number_quantity(metric.path, CheckedQuantityKind::simulated,
                              finite_number_or_nan(metric.value), 0)
        .error = standard_error;
    // The standard error of a rounding-sensitive value comes from few events, and is as uncertain
    // as the value itself.
    if (error == nullptr || metric.is_rounding_sensitive) return;
    in.append_number_quantity("error of " + metric.path, CheckedQuantityKind::simulated_error,
                              standard_error, 1);
  }

  const Metrics& metrics_;
  const BaselineCheckTolerances& tolerances_;
  const SolutionPartQuantityAppender& whole_;
  std::set<std::string> standard_error_paths_, coefficient_terms_, opened_parts_;
  /// Elements of each list of metrics, with the path of the list as key.
  std::map<std::string, std::set<std::string>> list_entries_;
};

}  // namespace

CheckedQuantities solution_quantities(const Solution& s,
                                      const BaselineCheckTolerances& tolerances) {
  CheckedQuantities quantities;
  const auto part = [&](const char* name, const char* value = "there") {
    return SolutionPartQuantityAppender{quantities, s.id(), name}.begin_part(
        CheckedQuantityKind::status, value);
  };
  const SolutionPartQuantityAppender whole = part(kWholeSolutionPart);
  whole.append_word_quantity("equation", equation_and_impact_text(s.identity));
  whole.append_word_quantity("status", std::string(name(s.status)));
  const SolutionPartQuantityAppender density = part("density", s.has_density() ? "one" : "none");
  if (s.has_density()) add_density_quantities(s, tolerances, density);
  // The kick-interval error of a simulation (white noise as kicks at finite intervals) is estimated
  // from the difference of two simulations. The estimate of the kick-interval error scatters by as
  // much as its value, and therefore does not reveal a change.
  if (s.error && !s.standard_errors) add_error_estimates(s, tolerances, part(kErrorEstimatePart));
  if (s.standard_errors) add_standard_error_quantities(*s.standard_errors, part("standard errors"));
  if (s.sampling) add_sampling_error_quantities(*s.sampling, part("sampling L1"));
  if (s.smooth_sampling)
    add_sampling_error_quantities(*s.smooth_sampling, part("sampling L1 in smooth bins"));
  add_metric_quantities(s.metrics, tolerances, whole);
  // For standard errors, add_metric_quantities() stores an exponent in CheckedQuantity::allowed.
  // The loop replaces the exponent in CheckedQuantity::allowed by the tolerance, adjusted for
  // multiple comparisons.
  const auto errors =
      std::ranges::count(quantities, CheckedQuantityKind::simulated_error, &CheckedQuantity::kind);
  for (CheckedQuantity& quantity : quantities) {
    if (quantity.kind != CheckedQuantityKind::simulated_error) continue;
    quantity.allowed = standard_error_change_tolerance(s, static_cast<std::size_t>(errors),
                                                       quantity.allowed, tolerances);
  }
  return quantities;
}

void add_metric_quantities(const Metrics& metrics, const BaselineCheckTolerances& tolerances,
                           const SolutionPartQuantityAppender& whole) {
  MetricQuantityAppender(metrics, tolerances, whole).append_all_metrics();
}

Metrics copy_metric_kinds_from_repeated_run(Metrics baseline, const Metrics& now) {
  std::set<std::string> ignored_paths;
  for (const auto& metric : now) {
    if (metric.kind == SolverMetricKind::work || metric.kind == SolverMetricKind::text)
      ignored_paths.insert(path_without_indices(metric.path));
  }
  // A metric in a list is also ignored if the new run ignores the whole list, or the corresponding
  // metric at another index of the list.
  const auto is_ignored = [&](const std::string& path) {
    for (auto end = path.find("[]"); end != std::string::npos; end = path.find("[]", end + 1)) {
      if (ignored_paths.contains(path.substr(0, end + 2))) return true;
    }
    return ignored_paths.contains(path);
  };
  for (auto& metric : baseline) {
    const SolverMetric* same = find_metric(now, metric.path);
    SolverMetric as_now = same != nullptr ? *same : SolverMetric{.path = metric.path, .value = {}};
    if (is_ignored(path_without_indices(metric.path))) as_now.kind = SolverMetricKind::work;
    as_now.value = std::move(metric.value);
    metric = std::move(as_now);
  }
  return baseline;
}

}  // namespace fpkcheck::check
