#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/files/input_file.hpp"
#include "base/options/enum_names.hpp"
#include "base/options/parameter_value.hpp"
#include "methods/method_interface.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::sweep {

enum class SweepAxisSpacing { linear, logarithmic, listed };
inline constexpr base::EnumEntry<SweepAxisSpacing> kSpacingNames[] = {
    {SweepAxisSpacing::linear, "linear"},
    {SweepAxisSpacing::logarithmic, "log"},
    {SweepAxisSpacing::listed, "list"}};
constexpr const auto& enumerator_names(SweepAxisSpacing) { return kSpacingNames; }
constexpr std::string_view name(SweepAxisSpacing spacing) { return base::name_of(spacing); }

/// A key of case files that a sweep varies, with the values of the key.
struct SweepAxis {
  std::string key;  ///< varied key, e.g. "system.restitution"
  SweepAxisSpacing spacing = SweepAxisSpacing::listed;
  double from = 0, to = 0;  ///< ends of the range of a numerical key
  /// Values of the varied key: numbers, or words such as "gaussian". The list of values is empty
  /// for a key that a Sobol sequence varies over a range.
  std::vector<base::Value> values = {};

  /// Returns the value of the varied key at a relative position in its range, rounded to 12 digits.
  /// @param part relative position, from 0 (lower end of the range) to 1
  double value_at_fraction(double part) const;
  /// Returns the axis of a sweep as text, e.g. "system.restitution = 0.5:0.99:50".
  std::string axis_definition_text() const;
};

/// Parses an axis in the syntax KEY=FROM:TO:N, KEY=FROM:TO or KEY=A,B,.., with "log:" before FROM
/// for a logarithmic axis.
/// @param error_context first words of error messages, e.g. "--vary" or "plan mine.ini:7"
/// @throws InputError if the syntax is invalid, a value is outside the range of the key, or a value
///         occurs twice
SweepAxis parse_sweep_axis(std::string_view key, std::string_view values,
                           const std::string& error_context);

enum class SweepPlanDesign {
  product,  ///< Cartesian product of the axes; the last axis varies fastest
  list,     ///< point k has the k-th value of every axis
  sobol     ///< a Sobol sequence in the box of the ranges
};
inline constexpr base::EnumEntry<SweepPlanDesign> kPlanDesignNames[] = {
    {SweepPlanDesign::product, "product", "every value with every other"},
    {SweepPlanDesign::list, "list", "the k-th values of all keys together"},
    {SweepPlanDesign::sobol, "sobol", "points of a Sobol sequence"}};
constexpr const auto& enumerator_names(SweepPlanDesign) { return kPlanDesignNames; }
constexpr std::string_view name(SweepPlanDesign design) { return base::name_of(design); }

inline constexpr std::size_t kMaxPoints = 1'000'000;

/// Points of a plan. Each point of a sweep plan has one value for each axis, in the order of the
/// axes.
using SweepPlanPoints = std::vector<std::vector<base::Value>>;

/// @param sobol_points number of points for the design `sobol`; 0 for other designs
/// @throws InputError if axes and design are inconsistent, or if the plan has more than kMaxPoints
///         points
SweepPlanPoints make_sweep_plan_points(const std::vector<SweepAxis>& axes, SweepPlanDesign design,
                                       std::size_t sobol_points);

/// Requires that each varied constant `parameters.NAME` is a constant of the base case, so that a
/// misspelt name does not solve the same problem at each point.
/// @throws InputError
void require_known_constants(const problem::Problem& base, const std::vector<SweepAxis>& axes);

enum class ClosureErrorSource {
  /// L1 distance from the reference solution of the sweep point, plus the error estimate of the
  /// reference.
  reference,
  residuals  ///< residual-based error estimates, which need no reference
};
inline constexpr base::EnumEntry<ClosureErrorSource> kClosureErrorSourceNames[] = {
    {ClosureErrorSource::reference, "reference"}, {ClosureErrorSource::residuals, "residuals"}};
constexpr const auto& enumerator_names(ClosureErrorSource) { return kClosureErrorSourceNames; }
constexpr std::string_view name(ClosureErrorSource errors) { return base::name_of(errors); }

/// Plan of a sweep: base case, varied keys with their values, and methods that solve each point.
struct SweepPlan {
  problem::Problem base;
  std::vector<SweepAxis> axes;
  SweepPlanDesign design = SweepPlanDesign::product;
  std::size_t sobol_points = 0;  ///< number of points for the design sobol; 0 for other designs
  std::vector<methods::Method> methods{};  ///< methods of the plan by increasing trust
  bool marginals = false;                  ///< whether the marginal densities are stored
  ClosureErrorSource closure_errors = ClosureErrorSource::reference;
  /// Whether the finite volumes also compute derivatives of moments with respect to the varied keys
  bool slopes = false;
  SweepPlanPoints points{};  ///< points of the plan, computed by make_sweep_plan_points()

  /// @throws InputError if the parameter values of the sweep point are inconsistent
  problem::Problem problem_at_sweep_point(std::size_t point) const;
};

/// Parsed sweep plan in which the methods are given by names, as input for a registry of solvers.
struct ParsedSweepPlan {
  problem::Problem base;
  std::vector<SweepAxis> axes{};
  std::optional<SweepPlanDesign> design{};
  std::optional<ClosureErrorSource> closure_errors{};
  std::optional<std::size_t> points{};
  std::optional<std::string> methods{};
  std::vector<base::IniSetting> options{};  ///< options of the methods, from section [sweep]
};

/// Reads a case file or a plan of a sweep. A plan is a case file with the additional sections
/// [sweep] and [vary]:
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
ParsedSweepPlan read_sweep_plan(const std::string& name_or_path,
                                const std::vector<std::string>& overrides);

}  // namespace fpkcheck::sweep
