#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "paper_cases.hpp"
#include "results/saved_run.hpp"
#include "workflows/check/case_quantities.hpp"
#include "workflows/check/compare_runs.hpp"

/// Runs to compare with each other; nothing is solved here.
namespace fpkcheck::tests {

/// The paper's first case from the repository: files store the values of metrics alone.
inline const results::Run& paper_baseline() {
  static const results::Run run = results::load_run(FPKCHECK_BASELINES "/case1");
  return run;
}

inline transform::Solution& solution(results::Run& run, std::string_view id) {
  for (auto& one : run.cases.at(0).solutions) {
    if (one.id() == id) return one;
  }
  throw std::logic_error("no " + std::string(id));
}

inline transform::SolverMetric& observation(transform::Solution& one, std::string_view path) {
  for (auto& found : one.metrics) {
    if (found.path == path) return found;
  }
  throw std::logic_error(one.id() + " has no " + std::string(path));
}

/// Sets the kind, scale and error path of a metric as its solver does.
inline void set_metric_kind(transform::SolverMetric& o) {
  using transform::SolverMetricKind;
  const std::string_view path = o.path;
  const auto is_one_of = [&](std::initializer_list<std::string_view> paths) {
    for (const auto one : paths) {
      if (path == one || path.starts_with(std::string(one) + '.')) return true;
    }
    return false;
  };
  const auto beside = [&](std::string_view last, const char* other) {
    return o.path.substr(0, path.size() - last.size()) + other;
  };
  o.kind = SolverMetricKind::result;  // words too
  if (is_one_of({"iterations",
                 "residual",
                 "condition",
                 "quadrature_change",
                 "homotopies",
                 "support.worst_direction",
                 "nonzeros",
                 "leak",
                 "steps",
                 "factorisations",
                 "rhs_evaluations",
                 "krylov_iterations",
                 "factor_entries",
                 "factor_seconds",
                 "krylov_seconds",
                 "stepped_against_direct",
                 "time",
                 "samples",
                 "impulses",
                 "flights",
                 "rounds",
                 "threads",
                 "seed",
                 "outside",
                 "variance_reduction",
                 "splitting_thresholds[]"}) ||
      path.ends_with(".lower") || path.ends_with(".upper")) {
    o.kind = SolverMetricKind::work;
  } else if (path.ends_with("_error") || path.starts_with("effective_samples")) {
    o.kind = SolverMetricKind::error;
  } else if (path.starts_with("coefficients") && path.ends_with("].a")) {
    o.kind = SolverMetricKind::coefficient;
    o.min_scale = 2e-8;
  } else if (is_one_of({"support.edge_density", "support.cut_off"})) {
    o.min_scale = 1e-6;
    o.is_rounding_sensitive = true;
  } else if (path == "error.observed_order") {
    o.is_rounding_sensitive = true;
  } else if (is_one_of({"wall_density"})) {
    o.min_scale = 1e-6;
  } else if (path.ends_with("].mean")) {
    o.standard_error_path = beside("mean", "standard_error");
  } else if (path.ends_with("].rate")) {
    o.standard_error_path = beside("rate", "standard_error");
  } else if (path.starts_with("quantiles") && path.ends_with("].value")) {
    o.standard_error_path = beside("value", "standard_error");
    o.is_rounding_sensitive = true;
  } else if (path == "excess_power.relative") {
    o.standard_error_path = "excess_power.standard_error";
  }
}

/// The same run as if this program had solved it: its metrics have their kinds.
inline const results::Run& solved_run() {
  static const results::Run run = [] {
    results::Run solved = paper_baseline();
    for (auto& one : solved.cases.at(0).solutions) {
      const bool is_simulation = one.standard_errors.has_value();
      for (auto& o : one.metrics) {
        set_metric_kind(o);
        if (is_simulation && o.path == "impact_rate") o.standard_error_path = "impact_rate_error";
        // Delicate where the rate comes from a handful of events.
        if (!o.path.ends_with("].rate")) continue;
        const double rate = *metric_number(one.metrics, o.path);
        o.is_rounding_sensitive =
            !(1.96 * *metric_number(one.metrics, o.standard_error_path) <= rate / 2);
      }
      // Older files have the interval alone: the standard error is derived from it.
      for (const char* list : {"quantiles.y", "quantiles.ydot"}) {
        for (int k = 0;; ++k) {
          const std::string entry = std::string(list) + '[' + std::to_string(k) + "].";
          const auto lower = metric_number(one.metrics, entry + "lower");
          const auto upper = metric_number(one.metrics, entry + "upper");
          if (!lower || !upper) break;
          one.metrics.push_back({.path = entry + "standard_error",
                                 .value = (*upper - *lower) / (2 * 1.96),
                                 .kind = transform::SolverMetricKind::error});
        }
      }
    }
    return solved;
  }();
  return run;
}

using Change = std::function<void(results::Run&)>;

/// The run as read from files, and as solved by this program.
struct TwoRuns {
  results::Run files = paper_baseline();
  results::Run solved = solved_run();
};

/// The run reduced to one solution, without pairs and budget.
inline results::Run only(results::Run run, const std::string& id) {
  results::CaseResult& one = run.cases.at(0);
  std::erase_if(one.solutions, [&](const auto& other) { return other.id() != id; });
  std::erase_if(one.curves, [&](const auto& curve) { return curve.solution != id; });
  one.pairs.clear();
  one.budget.clear();
  one.update_assessment();
  return run;
}
inline TwoRuns alone(const std::string& id) {
  return {.files = only(paper_baseline(), id), .solved = only(solved_run(), id)};
}

/// The compared quantities that change when the new run differs by `change` alone.
inline std::vector<check::CheckedQuantityChange> moved_by(
    const Change& change, const check::BaselineCheckTolerances& tolerances = {},
    const TwoRuns& runs = {}) {
  results::Run changed = runs.solved;
  change(changed);
  const auto forth =
      check::compare_runs(runs.files, changed, tolerances).quantities_beyond_tolerance();
  // The result must be the same with the runs exchanged.
  EXPECT_EQ(
      check::compare_runs(changed, runs.solved, tolerances).quantities_beyond_tolerance().size(),
      forth.size());
  return forth;
}

inline std::vector<check::CheckedQuantityKind> kinds(
    const std::vector<check::CheckedQuantityChange>& changes) {
  std::vector<check::CheckedQuantityKind> result;
  for (const auto& quantity_change : changes) result.push_back(quantity_change.kind);
  return result;
}

inline void scale(double& number, double relative) { number *= 1 + relative; }

/// Scales a metric of type double or integer.
inline void scale(transform::SolverMetric& o, double relative) {
  const transform::Metrics alone{o};
  o.value = transform::metric_number(alone, o.path).value() * (1 + relative);
}

inline Change scaled(const std::string& id, const std::string& path, double relative) {
  return [=](results::Run& run) { scale(observation(solution(run, id), path), relative); };
}

/// A case with one solution that has these metrics alone.
inline results::CaseResult case_of(transform::Metrics metrics) {
  transform::Solution one{.identity = {.id = "solution", .method = "toy"}};
  one.status = transform::Status::ok;
  one.metrics = std::move(metrics);
  return {.problem = paper_case(1),
          .solutions = {one},
          .pairs = {},
          .budget = {},
          .curves = {},
          .joints = {}};
}

}  // namespace fpkcheck::tests
