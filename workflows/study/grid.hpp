#pragma once

#include <optional>
#include <string>
#include <vector>

#include "methods/registry.hpp"
#include "methods/run_cases.hpp"
#include "problem/problem.hpp"
#include "report/figure/options.hpp"
#include "transform/richardson.hpp"
#include "workflows/study/output.hpp"
#include "workflows/study/record.hpp"

namespace fpkcheck::study {

/// Which grids to study.
struct GridStudyOptions {
  problem::Equation equation = problem::Equation::kf;
  problem::Impact impact = problem::Impact::map;
  std::vector<int> orders{3, 5, 7};           ///< of the scheme
  int levels = 5;                             ///< grids per order, at least 3
  double coarsest = 0.5;                      ///< refinement of the first level
  std::optional<double> origin_refinement{};  ///< as fd_fpk::Options has it
  /// Options of the simulation that stands beside the grids; all others are as usual.
  base::Values simulation{};
};

/// @throws InputError naming the option, its value and what is allowed
void validate(const GridStudyOptions& options);

/// A grid of a scheme.
struct GridRow {
  int order = 0;  ///< of the scheme
  int level = 1;
  double refinement = 1, origin_refinement = 1;
  int nx = 0, nv = 0;  ///< cells
  transform::Solution solution;
  std::optional<transform::Level> density = {};            ///< where it has one
  std::optional<transform::ObservedOrders> observed = {};  ///< with the two levels before
  std::optional<MarginalL1> l1 = {};                       ///< to the limit
};

/// What the grids of a scheme tend to, from the last three levels.
struct GridLimit {
  int order = 0;
  std::string none = {};  ///< why there is no limit; empty where there is one
  std::optional<transform::Level> density = {};
  transform::Moments error = {};      ///< what the extrapolation added to the moments, absolute
  std::optional<MarginalL1> l1 = {};  ///< to that of the highest order
};

/// A closure or a simulation beside them.
struct OtherRow {
  transform::Solution solution;
  std::optional<MarginalL1> l1 = {};
};

/// Everything is measured by the limit at the highest order.
struct GridStudy {
  static constexpr const char* kName = "grid";
  problem::Problem problem;
  transform::Identity grids;      ///< what the finite differences solve
  std::vector<GridRow> rows;      ///< by order, then by level
  std::vector<GridLimit> limits;  ///< by order
  std::vector<OtherRow> others;   ///< none without a limit
  /// How far the limit is known: its distance to that of the next lower order.
  std::optional<MarginalL1> known_to = {};

  const GridLimit& truth() const { return limits.back(); }
};

/// Solves a problem on grids of every order and level (null vector alone, one after the other, all
/// on the box of the first), by the closures and simulations of the same equation (other_methods),
/// and measures all by the Richardson limit at the highest order. Without densities that are ok, or
/// at an observed order below transform::kLeastOrderOfALimit, there is no limit, and no other
/// method is run.
/// @throws InputError as validate does
GridStudy study_grid(const problem::Problem& problem, const GridStudyOptions& options,
                     const methods::Registry& registry, const methods::ProgressListener& listener);

/// True when there is a limit, and no order's finest grid failed: coarse ones are looked at.
bool reached(const GridStudy& study);

/// The parts of `output`.
std::string json(const GridStudy& study, const std::string& command);
std::string csv(const GridStudy& study);
/// Grids, limits and other methods, and which method is the quickest for which accuracy.
std::string table(const GridStudy& study, const report::TextFormat& format);
/// L1 distance over the cell width by order, and over the time by all methods.
std::string figure(const GridStudy& study, const std::string& file_stem,
                   report::FigureWidth width = report::FigureWidth::screen);

Record record(const GridRow& row);
Record record(const GridLimit& limit);
Record record(const OtherRow& row);

}  // namespace fpkcheck::study
