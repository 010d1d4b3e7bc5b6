#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "problem/problem.hpp"

/// Reference values of the full jump equation with the exact impact condition.
namespace fpkcheck::study {

struct ReferenceOptions {
  /// Refinement factor of the grid of the seventh-order scheme. The cells of the fifth-order scheme
  /// are smaller than the cells of the seventh-order scheme by a factor sqrt(2).
  double refinement = 2;
  /// Simulated time; the default is 1e7 decay times of the slowest mode.
  std::optional<double> simulation_time{};
  std::uint64_t seed = 1;
};

/// Reference value by a seventh-order and by a fifth-order scheme: two Richardson limits, or two
/// values on the finest grids.
struct ValueInTwoSchemeOrders {
  double value_of_order_seven;
  double value_of_order_five;
  /// Returns the number of significant digits, at most `most`, to which the values of the
  /// seventh-order and fifth-order schemes agree.
  int agreed_significant_digits(int most) const;
};

struct ReferenceMoment {
  std::string name;    ///< key of the moment in summary.json, e.g. "y1"
  std::string symbol;  ///< symbol of the moment, e.g. "E[y]"
  ValueInTwoSchemeOrders value;
  double simulated;
  double standard_error;
};

struct ReferenceDensityPoint {
  double abscissa;
  ValueInTwoSchemeOrders density;
};

struct CaseReferenceValues {
  problem::Problem problem;
  std::string failure;  ///< reason why there is no reference; empty if the reference exists
  std::vector<ReferenceMoment> moments;
  std::vector<ReferenceDensityPoint> y, ydot;  ///< 20 points each of p(y) and p(y')
  double energy_residual = 0;                  ///< energy residual of the solution of seventh order
  double simulated_time = 0;
  /// Fraction of the bins of the simulation whose 95 % confidence interval contains the reference
  /// density.
  double y_coverage = 0, ydot_coverage = 0;
};

/// @throws InputError with a message of one line
void validate(const problem::Problem& problem, const ReferenceOptions& options);

/// Solves a problem by a fifth-order finite-volume scheme, a seventh-order scheme and a simulation.
/// Each finite-volume scheme uses three grids that are refined towards the origin.
CaseReferenceValues compute_reference(const problem::Problem& problem,
                                      const ReferenceOptions& options);

/// The CSV of reference values has the header case,quantity,abscissa,value,uncertainty. The
/// uncertainty of a reference value is the difference between the seventh-order and the fifth-order
/// value.
std::string reference_markdown(const std::vector<CaseReferenceValues>& references,
                               const std::string& command);
std::string reference_csv(const std::vector<CaseReferenceValues>& references);

}  // namespace fpkcheck::study
