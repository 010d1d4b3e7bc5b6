#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "problem/problem.hpp"

/// Reference values of the full jump equation with the exact impact, for tests of other programs.
namespace fpkcheck::study {

struct ReferenceOptions {
  /// Refinement of the grids of seventh order; those of fifth order are finer by sqrt(2).
  double refinement = 2;
  /// Default: 1e7 decay times of the slowest mode.
  std::optional<double> simulation_time{};
  std::uint64_t seed = 1;
};

/// A value by finite volumes of seventh and of fifth order: both Richardson limits, or both on the
/// finest grid.
struct ReferenceValue {
  double seventh;
  double fifth;
  /// Number of significant digits on which the two values agree, at most `most`.
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
  /// Fraction of the simulation's bins whose 95 % interval contains the reference.
  double y_coverage = 0, ydot_coverage = 0;
};

/// Checks problem and options before the solves, which take a minute.
/// @throws InputError with a message of one line
void validate(const problem::Problem& problem, const ReferenceOptions& options);

/// Solves by two discretisations, each on three grids graded to the origin, and simulates.
Reference reference(const problem::Problem& problem, const ReferenceOptions& options);

/// The tables as Markdown, and as CSV with the header case,quantity,abscissa,value,uncertainty. The
/// uncertainty is the difference of the two discretisations.
std::string reference_markdown(const std::vector<Reference>& references,
                               const std::string& command);
std::string reference_csv(const std::vector<Reference>& references);

}  // namespace fpkcheck::study
