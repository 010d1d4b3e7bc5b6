#pragma once

#include <optional>
#include <string>
#include <vector>

#include "methods/registry.hpp"
#include "methods/run_cases.hpp"
#include "problem/problem.hpp"
#include "report/figure/figure.hpp"
#include "transform/richardson.hpp"
#include "workflows/study/output.hpp"
#include "workflows/study/record.hpp"

namespace fpkcheck::study {

/// The grids of a grid study: equation, impact condition, orders of the scheme and levels of
/// refinement.
struct GridStudyOptions {
  problem::Equation equation = problem::Equation::kf;
  problem::Impact impact = problem::Impact::map;
  std::vector<int> orders{3, 5, 7};           ///< orders of the scheme
  int levels = 5;                             ///< number of grids for each order, at least 3
  double coarsest = 0.5;                      ///< refinement of the first level
  std::optional<double> origin_refinement{};  ///< as in fd_fpk::Options
  /// Options of the simulation that is compared with the grids; options that are not listed have
  /// their default values.
  base::Values simulation{};
};

/// @throws InputError naming the option, its value and its range
void validate(const GridStudyOptions& options);

/// A row of a grid study: the solution on one grid, and the distance of this solution to the limit.
struct GridRow {
  int order = 0;  ///< of the scheme
  int level = 1;
  double refinement = 1, origin_refinement = 1;
  int nx = 0, nv = 0;  ///< numbers of cells in y and y'
  transform::Solution solution;
  std::optional<transform::GridLevel> density = {};  ///< empty without a density
  std::optional<transform::ObservedConvergenceOrders> observed =
      {};                                      ///< from this level and two before
  std::optional<MarginalL1Distances> l1 = {};  ///< distance to the limit
};

/// The Richardson limit of the grids of one order of the scheme, extrapolated from the three finest
/// grids.
struct GridLimit {
  int order = 0;
  std::string failure = {};  ///< reason why there is no limit; empty where there is a limit
  std::optional<transform::GridLevel> density = {};
  transform::Moments error = {};  ///< differences of the moments to the finest grid, absolute
  std::optional<MarginalL1Distances> l1 = {};  ///< distance to the limit of the highest order
};

/// A closure or a simulation that is compared with the grids.
struct ComparedMethodRow {
  transform::Solution solution;
  std::optional<MarginalL1Distances> l1 = {};
};

/// The result of a grid study. The Richardson limit at the highest order is the reference of all
/// distances.
struct GridStudy {
  static constexpr const char* kName = "grid";
  problem::Problem problem;
  transform::SolutionIdentity grids;      ///< equation and impact of the finite volumes
  std::vector<GridRow> rows;              ///< by order, then by level
  std::vector<GridLimit> limits;          ///< by order
  std::vector<ComparedMethodRow> others;  ///< empty without a limit
  /// The accuracy of the limit at the highest order: the L1 distance to the limit at the next lower
  /// order.
  std::optional<MarginalL1Distances> limit_accuracy = {};

  const GridLimit& reference_limit() const { return limits.back(); }
};

/// Solves a problem by finite volumes on grids of every order and level, one grid after another.
/// The stationary density is computed as the null vector of the discrete operator only. All grids
/// use the box of the first grid. Then the closures and simulations of the same equation
/// (comparison_methods) solve the problem. The Richardson limit at the highest order is the
/// reference of all distances. A Richardson limit does not exist if a density is missing or its
/// status is not ok, or if the observed order of convergence is below transform::kMinOrderForLimit.
/// Without a Richardson limit at the highest order no closure or simulation is run.
/// @throws InputError in the same cases as validate
GridStudy study_grid(const problem::Problem& problem, const GridStudyOptions& options,
                     const methods::Registry& registry, const methods::ProgressListener& listener);

/// Whether the grid study has a Richardson limit, and the solver did not fail on the finest grid of
/// any order. Solutions on coarser grids may fail.
bool has_converged(const GridStudy& study);

/// The files and texts of a grid study, from which make_report() makes a StudyReport.
std::string json(const GridStudy& study, const std::string& command);
std::string csv(const GridStudy& study);
/// The tables of grids, limits and other methods, and the fastest method for each accuracy.
std::string table(const GridStudy& study, const report::TextFormat& format);
/// The L1 distances against the refinement of the grid for each order of the scheme, and against
/// the wall-clock time for all methods; without panels if no distance is known.
report::Figure figure(const GridStudy& study);

Record make_record(const GridRow& row);
Record make_record(const GridLimit& limit);
Record make_record(const ComparedMethodRow& row);

}  // namespace fpkcheck::study
