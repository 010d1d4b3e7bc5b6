#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fd_fpk/transient.hpp"
#include "problem/problem.hpp"
#include "report/figure/figure.hpp"

namespace fpkcheck::study {

/// A density over time with problem and options. Files, figures and tables are made from this
/// object.
struct TransientRun {
  std::string command;  ///< the command line
  problem::Problem problem;
  fd_fpk::Options options;
  fd_fpk::TransientOptions transient;
  fd_fpk::TransientResult result;
};

/// Version of the schema of transient_json.
inline constexpr int kTransientSchema = 1;

/// The JSON of a density over time, without the marginal densities: program, case, options, status,
/// counts, and the quantities of each snapshot.
std::string transient_json(const TransientRun& run);

/// The table of a density over time for the terminal, in plain ASCII: a line of parameters, a row
/// for each snapshot (or for evenly selected snapshots, if there are many), and the reason if the
/// status is not ok.
/// @param width characters per line of the sentences; the rows of the table always have 78
///              characters
std::string transient_table(const TransientRun& run, std::size_t width);

/// The densities p(y, t) and p(y', t) as maps over time.
/// @pre the run has at least two snapshots
report::Figure transient_figure(const TransientRun& run);

/// Writes a density over time to a netCDF-4 file (HDF5) that follows the CF conventions:
///
///     dimensions   time, y, ydot, bounds = 2
///     coordinates  time(time), y(y), ydot(ydot): centres of cells; their edges are in
///                  y_bounds(y, bounds), ydot_bounds(ydot, bounds)
///     marginals    p_y(time, y), p_ydot(time, ydot): averages over cells
///     over time    y1, y2, y4, v1, v2, v4 (moments as in summary.json), yv = E[y y'], energy,
///                  power, power_residual, impact_rate, mass, min_density
///
/// The global attributes are the command, the case, the options, the initial state and the status.
/// All quantities are non-dimensional. The file is either written completely or left unchanged.
/// @pre the run has at least one snapshot
/// @throws std::runtime_error with a message of one line if the file cannot be written
void write_transient_netcdf(const std::filesystem::path& file, const TransientRun& run);

/// The stem of the file names, in figures/, of a case's figure of the density over time.
std::string transient_picture_stem(const std::string& case_name);

/// Writes transient.nc, the script figures/transient-CASE.gp and the pictures of this script into a
/// directory that prepare_output_directory prepared. Each file is complete or absent. A file of an
/// earlier run of the case is removed if this run has no data for such a file.
/// @param gnuplot program that draws the pictures
/// @return warnings about pictures that could not be drawn, one line each
/// @throws std::runtime_error if a file cannot be written
std::vector<std::string> write_transient(const std::filesystem::path& directory,
                                         const TransientRun& run,
                                         const report::FigureOptions& figures = {},
                                         const std::string& gnuplot = "gnuplot");

}  // namespace fpkcheck::study
