#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "problem/problem.hpp"

/// Reference values of the full jump equation with the exact impact, for others to test against.
namespace fpkcheck::study {

struct ReferenceOptions {
  /// Of the seventh-order grid; the fifth order's is finer by sqrt(2).
  double refinement = 2;
  /// Automatic: 1e7 decay times of the slowest mode.
  std::optional<double> simulation_time{};
  std::uint64_t seed = 1;
};

/// A value by finite differences of seventh order and by those of fifth order, both Richardson
/// limits or on the finest grid.
struct ReferenceValue {
  double seventh;
  double fifth;
  /// Significant digits on which the two agree, at most `most`.
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
  std::string failure;  ///< why there is no reference; empty when there is one
  std::vector<ReferenceMoment> moments;
  std::vector<ReferencePoint> y, ydot;  ///< 20 points each of p(y), p(y')
  double energy_residual = 0;           ///< of the seventh order
  double simulated_time = 0;
  /// Share of the simulation's histogram bins whose 95 % interval holds the reference.
  double y_bins_within = 0, ydot_bins_within = 0;
};

/// All that can be known to be wrong before anything is solved, which takes a minute.
/// @throws InputError on one line
void validate(const problem::Problem& problem, const ReferenceOptions& options);

/// Solves by two discretisations, each with three grids graded to the origin, and simulates.
Reference reference(const problem::Problem& problem, const ReferenceOptions& options);

/// The tables as Markdown, and as CSV with the header case,quantity,abscissa,value,uncertainty,
/// where the uncertainty is the difference of the two discretisations.
std::string reference_markdown(const std::vector<Reference>& references,
                               const std::string& command);
std::string reference_csv(const std::vector<Reference>& references);

}  // namespace fpkcheck::study
