#pragma once

#include <optional>
#include <string>
#include <vector>

#include "methods/registry.hpp"
#include "methods/run_cases.hpp"
#include "problem/problem.hpp"
#include "report/figure/figure.hpp"
#include "transform/richardson.hpp"
#include "workflows/study/study_record.hpp"
#include "workflows/study/study_report.hpp"

namespace fpkcheck::study {

struct GridStudyOptions {
  problem::DensityEquation equation = problem::DensityEquation::kf;
  problem::ImpactCondition impact = problem::ImpactCondition::map;
  std::vector<int> orders{3, 5, 7};  ///< convergence orders of the finite-volume schemes
  int levels = 5;                    ///< number of grids for each scheme, at least 3
  double coarsest = 0.5;             ///< refinement of the coarsest grid
  /// Refinement of the grids towards the origin, as FiniteVolumeOptions::origin_refinement.
  std::optional<double> origin_refinement{};
  /// Options of the simulation that is compared with the grids; missing options have default
  /// values.
  base::Values simulation{};
};

/// @throws InputError that states the option, the value and the range
void validate(const GridStudyOptions& options);

struct GridStudyRow {
  int order = 0;  ///< convergence order of the scheme
  int level = 1;
  double refinement = 1, origin_refinement = 1;
  int nx = 0, nv = 0;  ///< numbers of grid cells in y and y'
  transform::Solution solution;
  /// Marginal densities and moments of the solution on one grid; empty if the solution has no
  /// density.
  std::optional<transform::GridLevelSolution> density = {};
  /// Observed convergence orders, from the grid of the row and the next two coarser grids.
  std::optional<transform::ObservedConvergenceOrders> observed = {};
  std::optional<MarginalL1Distances> l1 = {};  ///< L1 distances from the Richardson limit
};

/// Richardson limit of the grids of one scheme order, extrapolated from the three finest grids.
struct RichardsonLimit {
  int order = 0;
  std::string failure = {};  ///< reason why there is no limit; empty if the limit exists
  std::optional<transform::GridLevelSolution> density = {};
  /// Absolute differences of the moments between the Richardson limit and the finest grid.
  transform::Moments error = {};
  /// L1 distances from the Richardson limit of the highest-order scheme.
  std::optional<MarginalL1Distances> l1 = {};
};

struct ComparedMethodRow {
  transform::Solution solution;
  std::optional<MarginalL1Distances> l1 = {};
};

/// Results of a grid study. The Richardson limit of the highest-order scheme is the reference of
/// all L1 distances in a grid study.
struct GridStudy {
  static constexpr const char* kName = "grid";
  static constexpr const char* kFileStem = "study-grid";
  problem::Problem problem;
  transform::SolutionIdentity grids;    ///< equation and impact condition of the finite volumes
  std::vector<GridStudyRow> rows;       ///< rows sorted by scheme order, then by grid level
  std::vector<RichardsonLimit> limits;  ///< Richardson limits sorted by scheme order
  /// Closures and simulations that are compared with the finite-volume grids; empty without a
  /// Richardson limit.
  std::vector<ComparedMethodRow> others;
  /// L1 distance between the Richardson limits of the highest and the next lower scheme order.
  std::optional<MarginalL1Distances> limit_accuracy = {};

  const RichardsonLimit& reference_richardson_limit() const { return limits.back(); }
};

/// Solves a problem by finite volumes on grids of every order and level, one grid after another.
/// All grids of a study use the domain of the first grid, and the null vector of the discrete
/// operator as density. A Richardson limit exists if the three finest grids have densities and the
/// solution on the finest grid is ok. A Richardson limit also requires that the observed order
/// satisfies transform::has_richardson_limit(). If the Richardson limit of the highest-order scheme
/// exists, the methods of methods_compared_with_grids() also solve the problem.
/// @throws the exceptions of validate()
GridStudy study_grid(const problem::Problem& problem, const GridStudyOptions& options,
                     const methods::SolverRegistry& registry,
                     const methods::ProgressListener& listener);

/// Returns whether the Richardson limit of a grid study exists and no solver failed on the finest
/// grid of a scheme. Solver failures on coarser grids are ignored.
bool has_converged(const GridStudy& study);

/// Files and texts of a grid study, from which make_study_report() makes a StudyReport.
std::string study_json_text(const GridStudy& study, const std::string& command);
std::string study_csv_text(const GridStudy& study);
/// Returns the tables of grids, Richardson limits and compared methods, and the fastest method for
/// each accuracy.
std::string study_table_text(const GridStudy& study, const report::TerminalTextFormat& format);
/// Returns a figure with panels of the L1 distances against the grid refinement and against the
/// wall-clock time of all methods. Without any known L1 distance the figure has no panels.
report::Figure study_figure(const GridStudy& study);

StudyRecord make_study_record(const GridStudyRow& row);
StudyRecord make_study_record(const RichardsonLimit& limit);
StudyRecord make_study_record(const ComparedMethodRow& row);

}  // namespace fpkcheck::study
