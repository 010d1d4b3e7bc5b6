#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "methods/external/density_points.hpp"
#include "methods/method.hpp"

/// Densities that somebody brings along, as methods that solve nothing. Where it is said what they
/// are to solve they are closures: judged by their distance to the reference and its error budget,
/// and never the judge.
namespace fpkcheck::methods {

/// What is said of such a density.
struct OwnDensity {
  std::string label;  ///< the solution's id (methods/external/label.hpp)
  /// Nothing: nobody knows, and there is no error budget.
  std::optional<problem::Equation> equation = {};
  problem::Impact impact = problem::Impact::map;  ///< of an equation
  std::size_t place = 0;                          ///< among several, for pictures
  std::optional<int> order = {};                  ///< where it stands among closures
};

/// Who it is.
/// @param method transform::kGivenMethods
/// @param what "given as a function"
transform::Identity identity_of(const OwnDensity& own, std::string_view method,
                                const std::string& what);

/// How the values of a joint density are taken.
struct OwnFunction {
  bool normalise = true;  ///< divide by the integral ("normalised_by" says by what)
  /// Of an equation: largest error of p(y) and of p(y') in L1, as its residuals measure it, with
  /// which it is ok.
  double accuracy = 0.02;
  std::string objection = {};  ///< why it is no density, as is known already; empty: it is not
};

/// A function, from its values; as averages over the cells of the points. Its status is
/// `inadmissible` where values are negative, where it is cut off at the last edge, or where it is
/// not normalised and its integral is not 1.
/// @param values row-major, shape (points.y(), points.v())
/// @throws InputError when a value is not finite, or the integral is not positive
Method own_function(const OwnDensity& own, const OwnFunction& how, const DensityPoints& points,
                    std::vector<double> values);

/// Says, as notes[0], that the mass which rests in contact (problem::Features) is no part of a
/// density of one's own.
void note_rest(const problem::Problem& problem, transform::MetricBuilder& builder);

/// The integral of values as own_function takes them.
/// @throws InputError as own_function
double require_density(const OwnDensity& own, const DensityPoints& points,
                       const std::vector<double>& values);

/// The solution that own_function's method returns, from values that require_density took.
/// @param mass their integral
transform::Solution solution_of(const problem::Problem& problem, const Setting& setting,
                                const OwnDensity& own, const OwnFunction& how,
                                const DensityPoints& points, std::vector<double> values,
                                double mass);

}  // namespace fpkcheck::methods
