#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/files/ini_file.hpp"
#include "problem/problem.hpp"
#include "workflows/sweep/plan/plan.hpp"

namespace fpkcheck::sweep {

/// A parsed plan that has the names of methods instead of the methods: a registry makes the methods
/// from these names.
struct PlanSpecification {
  problem::Problem base;
  std::vector<Axis> axes{};
  std::optional<PlanDesign> design{};
  std::optional<ClosureErrorSource> closure_errors{};
  std::optional<std::size_t> points{};
  std::optional<std::string> methods{};
  std::vector<base::IniSetting> options{};  ///< options of the methods: all other lines of [sweep]
};

/// Reads a case (as problem::load_case) or a plan. A plan is a case file with two additional
/// sections:
///
///     [sweep]
///     case = case1            ; instead of [system] and [impulse]
///     methods = epc,fd-kf
///     design = product        ; or list, sobol
///     points = 1000           ; for the design sobol
///     closure_errors = residuals   ; or reference
///     max_seconds = 5         ; an option of the methods
///     [vary]
///     system.restitution = 0.5:0.99:50
///     impulse.rate = log:0.2:20:9
///
/// @param name_or_path "case1" .. "case4", a case file or a plan
/// @param overrides "key=value" pairs that replace values of the case
/// @throws InputError with a message of one line
PlanSpecification read_plan(const std::string& name_or_path,
                            const std::vector<std::string>& overrides);

}  // namespace fpkcheck::sweep
