#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "compare/run_cases.hpp"
#include "compare/text/format.hpp"
#include "fd_fpk/options.hpp"
#include "mcs/simulate.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::compare {

/// Which grids to study.
struct GridStudyOptions {
  fd_fpk::Equation equation = fd_fpk::Equation::kf;
  problem::Impact impact = problem::Impact::map;
  std::vector<int> orders{3, 5, 7};           ///< of the scheme, each once
  int levels = 5;                             ///< grids per order, at least 3
  double coarsest = 0.5;                      ///< refinement of the first level
  std::optional<double> origin_refinement{};  ///< as fd_fpk::Options has it
  mcs::Options simulation{};                  ///< of the simulation that stands beside the grids
};

/// Cells of a level are this much narrower than those of the one before.
inline constexpr double kGridLevelRatio = 1.4142135623730951;

/// @throws InputError naming the option, its value and what is allowed
void validate(const GridStudyOptions& options);

/// Solves a problem on grids of every order and level (null vector alone, one after the other, all
/// on the box of the first), by the closures of the same equation and by simulation, and returns
/// the contents of study-grid.json: program, name, system and impulse of the case as in
/// summary.json, and
///  - truth: the Richardson limit at the highest order, with the L1 distances to the limit at the
///    next order (`y`, `ydot`), which is how far it is known; null without a second order. Without
///    densities that are ok, or at an observed order below kLeastOrderOfALimit, there is none
///    (`reason`), and no other method is run;
///  - limits: per order the limits of the moments and the L1 distances of the marginals to truth;
///  - rows: per order and level the cells, the L1 distances of the marginals to truth, the observed
///    order log |u_1 - u_0| / |u_2 - u_1| / log ratio of the last three levels in L1, E[y^2] and
///    E[y'^2], the time;
///  - others: per closure and for the simulation the L1 distances to truth and the time.
/// Null where there is no number.
/// @param command the command line of the run
/// @throws InputError as validate does
nlohmann::ordered_json study_grid(const std::string& command, const problem::Problem& problem,
                                  const GridStudyOptions& options,
                                  const ProgressListener& listener);

/// Grids and other methods as study-grid.csv, under a header; empty where there is no number.
std::string grid_csv(const nlohmann::ordered_json& report);

/// Grids, limits and other methods as tables, and in sentences which method is the quickest for
/// which accuracy.
/// @param format the least important columns go where the rows do not fit
std::string grid_table(const nlohmann::ordered_json& report, const TextFormat& format = {});

/// A gnuplot script: L1 distance over the cell width by order, and over the time by all methods;
/// empty where there is nothing to draw.
std::string grid_figure(const nlohmann::ordered_json& report, const std::string& file_stem);

}  // namespace fpkcheck::compare
