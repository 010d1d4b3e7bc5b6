#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "problem/problem.hpp"

/// Reference values of the full jump equation with the exact impact condition, for tests of other
/// programs.
namespace fpkcheck::study {

struct ReferenceOptions {
  /// Refinement of the grids of the seventh-order scheme; the grids of the fifth-order scheme are
  /// finer by sqrt(2).
  double refinement = 2;
  /// The simulated time; by default 1e7 decay times of the slowest mode.
  std::optional<double> simulation_time{};
  std::uint64_t seed = 1;
};

/// A value from finite volumes of seventh order and from finite volumes of fifth order. Both values
/// are Richardson limits, or both values come from the finest grid.
struct ReferenceValue {
  double seventh;
  double fifth;
  /// Number of significant digits to which both values agree, at most `most`.
  int agreed_digits(int most) const;
};

struct ReferenceMoment {
  std::string name;    ///< as in summary.json: "y1" ...
  std::string symbol;  ///< "E[y]" ...
  ReferenceValue value;
  double simulated;
  double standard_error;
};

struct ReferencePoint {
  double abscissa;
  ReferenceValue density;
};

struct Reference {
  problem::Problem problem;
  std::string failure;  ///< reason why there is no reference; empty where there is a reference
  std::vector<ReferenceMoment> moments;
  std::vector<ReferencePoint> y, ydot;  ///< 20 points each of p(y) and p(y')
  double energy_residual = 0;           ///< of the solution of seventh order
  double simulated_time = 0;
  /// Fraction of the simulation's bins whose 95 % interval contains the reference density.
  double y_coverage = 0, ydot_coverage = 0;
};

/// Checks problem and options before the problem is solved, which takes a minute.
/// @throws InputError with a message of one line
void validate(const problem::Problem& problem, const ReferenceOptions& options);

/// Computes reference values: solves a problem by two discretisations, each on three grids that are
/// refined towards the origin, and simulates the problem.
Reference compute_reference(const problem::Problem& problem, const ReferenceOptions& options);

/// The tables of reference values in Markdown, and in CSV with the header
/// case,quantity,abscissa,value,uncertainty. The uncertainty is the difference between the values
/// of both discretisations.
std::string reference_markdown(const std::vector<Reference>& references,
                               const std::string& command);
std::string reference_csv(const std::vector<Reference>& references);

}  // namespace fpkcheck::study
