#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fd_fpk/transient.hpp"
#include "problem/problem.hpp"
#include "report/figure/options.hpp"

namespace fpkcheck::study {

/// A density over time with its problem and options: the source of its files, figures and tables.
struct TransientRun {
  std::string command;  ///< the command line
  problem::Problem problem;
  fd_fpk::Options options;
  fd_fpk::TransientOptions transient;
  fd_fpk::TransientResult result;
};

/// Version of the schema of transient_json.
inline constexpr int kTransientSchema = 1;

/// JSON of a density over time without the marginals: program, case, options, status, counts, and
/// the quantities of each snapshot.
std::string transient_json(const TransientRun& run);

/// Table for the terminal: a line of parameters, a row for each snapshot (an even selection when
/// there are many), and the reason when the status is not ok. Plain ASCII.
/// @param width characters per line of the sentences; rows take 78
std::string transient_table(const TransientRun& run, std::size_t width);

/// A gnuplot script that draws (a) p(y, t) and (b) p(y', t) as colour maps over time. The script
/// contains the data. It draws FILE_STEM.png, or the format of format='svg', 'pdf' or 'tex'; the
/// gnuplot variable `target` names another file.
/// @param run must have at least two snapshots
std::string transient_figure(const TransientRun& run, const std::string& file_stem,
                             report::FigureWidth width = report::FigureWidth::screen);

/// Writes a density over time as netCDF-4 (an HDF5 file), following the CF conventions:
///
///     dimensions   time, y, ydot, bounds = 2
///     coordinates  time(time), y(y), ydot(ydot): centres of cells; their edges are in
///                  y_bounds(y, bounds), ydot_bounds(ydot, bounds)
///     marginals    p_y(time, y), p_ydot(time, ydot): averages over cells
///     over time    y1, y2, y4, v1, v2, v4 (moments as in summary.json), yv = E[y y'], energy,
///                  power, power_residual, impact_rate, mass, min_density
///
/// The global attributes hold the command, the case, the options, the start and the status. All
/// quantities are non-dimensional. The file is written completely or not changed.
/// @param run must have at least one snapshot
/// @throws std::runtime_error with a message of one line when the file cannot be written
void write_transient_netcdf(const std::filesystem::path& file, const TransientRun& run);

/// Stem of the file names in figures/ for a case's figure over time.
std::string transient_picture_stem(const std::string& case_name);

/// Writes transient.nc and figures/transient-CASE.gp with its pictures into a directory that
/// prepare_output_directory prepared. Each file is complete or absent. Files of an earlier run of the case are
/// removed when this run has no data for them.
/// @param gnuplot program that draws the pictures
/// @return warnings, one line each, about pictures that could not be drawn
/// @throws std::runtime_error when a file cannot be written
std::vector<std::string> write_transient(const std::filesystem::path& directory,
                                         const TransientRun& run,
                                         const report::FigureOptions& figures = {},
                                         const std::string& gnuplot = "gnuplot");

}  // namespace fpkcheck::study
