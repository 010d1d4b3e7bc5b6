#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fd_fpk/transient.hpp"
#include "problem/problem.hpp"
#include "report/figure/options.hpp"

namespace fpkcheck::study {

/// A density over time with what it was asked for: files, pictures and tables are made from it.
struct TransientRun {
  std::string command;  ///< the command line
  problem::Problem problem;
  fd_fpk::Options options;
  fd_fpk::TransientOptions transient;
  fd_fpk::TransientResult result;
};

/// Version of the shape of transient_json.
inline constexpr int kTransientSchema = 1;

/// As JSON, everything a density over time tells but the marginals: program, case, options, status,
/// counts, and what holds at each snapshot.
std::string transient_json(const TransientRun& run);

/// The terminal table: a line of parameters, a row a snapshot (thinned evenly when there are many),
/// and the reason when the status is not ok. Plain ASCII.
/// @param width characters per line of the texts; rows take 78
std::string transient_table(const TransientRun& run, std::size_t width);

/// A gnuplot script that draws (a) p(y, t) and (b) p(y', t) as colour maps over time. It holds its
/// data, and draws FILE_STEM.png or, with format='svg', 'pdf' or 'tex', that; the gnuplot variable
/// `target` names another file.
/// @param run with at least two snapshots
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
/// The global attributes hold the command, the case, the options, the start and the status. All is
/// non-dimensional. The file is either whole or as it was.
/// @param run with at least one snapshot
/// @throws std::runtime_error on one line when it cannot be written
void write_transient_netcdf(const std::filesystem::path& file, const TransientRun& run);

/// The name under which a case's picture over time is filed in figures/, without extension.
std::string transient_picture_stem(const std::string& case_name);

/// Writes transient.nc and figures/transient-CASE.gp with its pictures into a directory that
/// make_writable prepared. Each file is either whole or absent; those of an earlier run of the case
/// do not stay when there is nothing to put in their place.
/// @param gnuplot the program that draws
/// @return warnings, one line each, about pictures that could not be drawn
/// @throws std::runtime_error when a file cannot be written
std::vector<std::string> write_transient(const std::filesystem::path& directory,
                                         const TransientRun& run,
                                         const report::FigureOptions& figures = {},
                                         const std::string& gnuplot = "gnuplot");

}  // namespace fpkcheck::study
