#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compare/axes.hpp"
#include "compare/bounds.hpp"
#include "compare/comparison.hpp"
#include "problem/problem.hpp"
#include "transform/density.hpp"
#include "transform/solution.hpp"

/// The result of a run as a type. The result is complete before any file is written. Tables,
/// figures and the page are made from this type, for computed runs as for runs read from files.
namespace fpkcheck::results {

/// A marginal density of one solution, as in marginals.csv.
struct Curve {
  std::string solution;  ///< id
  transform::Variable variable;
  std::vector<double> abscissa;  ///< n bin centres
  std::vector<double> density;   ///< n bin averages
  std::vector<double> lower;     ///< n lower ends of 95 % intervals, or empty
  std::vector<double> upper;     ///< n upper ends, or empty

  bool operator==(const Curve&) const = default;
};

/// The widths of a curve's bins, shape (n). Precondition: the bins are contiguous, and either have
/// the same width or 0 as one of their edges.
std::vector<double> bin_widths(const Curve& curve);

/// The joint density of (y, y') of one solution, as averages over common cells.
struct JointDensity {
  std::string solution;  ///< id
  transform::GridDensity density;
};

/// Residual-based error estimates of the moments of a solution, from its density and the problem
/// alone (docs/residuals.md).
struct MomentErrorEstimate {
  std::string solution;          ///< id
  transform::Moments corrected;  ///< corrected moments E[f]
  transform::Moments error;      ///< the solution's moments minus the corrected moments
};

/// The sources of the error of a moment, as a density over the cells of the joint densities: the
/// integral over a region is its contribution to the error. The sum over all cells is the error,
/// except for contributions from outside the cells.
struct ErrorSource {
  std::string solution;  ///< id
  std::string moment;    ///< its name in transform::kMoments: y2, v2
  transform::GridDensity density;
};

/// The result of a run for one case.
struct Case {
  problem::Problem problem;
  std::vector<transform::Solution> solutions;  ///< by increasing trust
  std::vector<compare::PairDistances> pairs;
  std::vector<compare::BudgetRow> budget;
  std::string limits;  ///< one sentence; empty without a budget
  std::vector<Curve> curves;
  std::vector<JointDensity> joints;  ///< of the solutions that have one, all on the same cells
  /// Curves of all solutions over smooth bins, where a solution has smooth estimates
  /// (compare/smooth_reference.hpp).
  std::vector<Curve> smooth = {};
  std::vector<MomentErrorEstimate> moment_error_estimates =
      {};  ///< in the order of the solutions that have one
  std::vector<ErrorSource> error_sources = {};
  std::optional<compare::Bounds> bounds = {};  ///< no value where they were not computed

  const std::string& name() const { return problem.name; }
  /// The solution with this id, or null.
  const transform::Solution* find(std::string_view id) const {
    return transform::find_solution(solutions, id);
  }
  /// The curve of a solution, or null.
  const Curve* curve(std::string_view solution, transform::Variable variable) const;
  /// The curve of a solution over smooth bins, or null.
  const Curve* smooth_curve(std::string_view solution, transform::Variable variable) const;
  /// The moment error estimates of a solution, or null.
  const MomentErrorEstimate* moment_error_estimate(std::string_view solution) const;
  /// The sources of the error of a moment, or null.
  const ErrorSource* error_source(std::string_view solution, std::string_view moment) const;
  /// compare::l1_between for the pairs of this case.
  std::optional<double> l1(std::string_view one, std::string_view other,
                           transform::Variable variable) const {
    return compare::l1_between(pairs, one, other, variable);
  }
};

/// The program and the command of a run.
struct Program {
  std::string name, version, command;
};

/// This program.
/// @param command the command line of the run
Program this_program(const std::string& command);

/// The checksum of a file of a run at the time of saving.
struct FileChecksum {
  std::string file;   ///< file name
  std::string crc32;  ///< results::crc32
};

struct Run {
  Program program;
  std::vector<Case> cases;
  /// One sentence on the interruption of the run and its missing parts; empty for a complete run.
  std::string stopped = {};
  std::vector<FileChecksum> files = {};  ///< of a run read from files; empty for older runs
};

/// Compares the solutions of a case and collects the result.
/// @param solutions by increasing trust
Case make_case(const problem::Problem& problem, const compare::ComparisonAxes& axes,
               std::vector<transform::Solution> solutions);

}  // namespace fpkcheck::results
