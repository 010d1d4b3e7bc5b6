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

/// What a run found, as a type. It is complete before anything is written; tables, pictures and the
/// page are made from it, whether it was just computed or read back from files.
namespace fpkcheck::results {

/// A marginal density of one solution, as marginals.csv holds it.
struct Curve {
  std::string solution;  ///< id
  transform::Variable variable;
  std::vector<double> abscissa;  ///< n bin centres
  std::vector<double> density;   ///< n bin averages
  std::vector<double> lower;     ///< n lower ends of 95 % intervals, or empty
  std::vector<double> upper;     ///< n upper ends, or empty

  bool operator==(const Curve&) const = default;
};

/// The widths of a curve's bins, shape (n): bins join, and are all as wide, or 0 is one of their edges.
std::vector<double> bin_widths(const Curve& curve);

/// The joint density of (y, y') of one solution, as averages over common cells.
struct JointDensity {
  std::string solution;  ///< id
  transform::GridDensity density;
};

/// What the moments of a solution are off by, from its density and the problem alone
/// (docs/residuals.md).
struct OwnError {
  std::string solution;          ///< id
  transform::Moments corrected;  ///< E[f] without the error
  transform::Moments error;      ///< the solution's moments less these
};

/// Where the error of a moment comes from: values over the cells of the joint densities, which times
/// the areas sum to the error but for what lies beyond the cells.
struct ErrorSource {
  std::string solution;  ///< id
  std::string moment;    ///< its name in transform::kMoments: y2, v2
  transform::GridDensity density;
};

/// Everything a run found out about one case.
struct Case {
  problem::Problem problem;
  std::vector<transform::Solution> solutions;  ///< by increasing trust
  std::vector<compare::PairDistances> pairs;
  std::vector<compare::BudgetRow> budget;
  std::string limits;  ///< one sentence; empty without a budget
  std::vector<Curve> curves;
  std::vector<JointDensity> joints;  ///< of the solutions that have one, all on the same cells
  /// Of all solutions in smooth bins, where one of them knows itself so (compare/smooth_reference.hpp).
  std::vector<Curve> smooth = {};
  std::vector<OwnError> own_errors = {};  ///< of those that have one, in their order
  std::vector<ErrorSource> error_sources = {};
  std::optional<compare::Bounds> bounds = {};  ///< nothing where they were not computed

  const std::string& name() const { return problem.name; }
  /// The solution with this id, or null.
  const transform::Solution* find(std::string_view id) const {
    return transform::find_solution(solutions, id);
  }
  /// The curve of a solution, or null.
  const Curve* curve(std::string_view solution, transform::Variable variable) const;
  /// The same in smooth bins.
  const Curve* smooth_curve(std::string_view solution, transform::Variable variable) const;
  /// Own error of a solution, and where that of a moment comes from, or null.
  const OwnError* own_error(std::string_view solution) const;
  const ErrorSource* error_source(std::string_view solution, std::string_view moment) const;
  /// compare::l1_between of its pairs.
  std::optional<double> l1(std::string_view one, std::string_view other,
                           transform::Variable variable) const {
    return compare::l1_between(pairs, one, other, variable);
  }
};

/// Which program made a run, and how.
struct Program {
  std::string name, version, command;
};

/// This program.
/// @param command the command line of the run
Program this_program(const std::string& command);

/// What a file of a run was when the run was saved.
struct FileChecksum {
  std::string file;   ///< its name
  std::string crc32;  ///< results::crc32
};

struct Run {
  Program program;
  std::vector<Case> cases;
  /// That the run was told to stop, and what is missing for it, in one sentence; empty when it came
  /// to its end.
  std::string stopped = {};
  std::vector<FileChecksum> files = {};  ///< of a run that was read; none in older ones
};

/// Compares the solutions of a case and keeps what is saved of them.
/// @param solutions by increasing trust
Case make_case(const problem::Problem& problem, const compare::ComparisonAxes& axes,
               std::vector<transform::Solution> solutions);

}  // namespace fpkcheck::results
