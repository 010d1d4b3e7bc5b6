#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fd_fpk/transient.hpp"
#include "problem/problem.hpp"
#include "report/figure/figure.hpp"

namespace fpkcheck::study {

/// A density of a case over time, with the problem and the options of the computation. Files,
/// figures and tables of a density over time are made from a TransientRun.
struct TransientRun {
  std::string command;
  problem::Problem problem;
  fd_fpk::FiniteVolumeOptions options;
  fd_fpk::TransientOptions transient;
  fd_fpk::TransientResult result;
};

inline constexpr int kTransientSchema = 1;

/// Returns the JSON text of a density over time, without the marginal densities.
std::string transient_json(const TransientRun& run);

/// Returns the table of a density over time in ASCII. The table has a row for each snapshot, or for
/// each of a selection of evenly spaced snapshots.
/// @param width characters per line of the sentences; the rows of the table always have 78
///        characters
std::string transient_table(const TransientRun& run, std::size_t width);

/// Returns a figure with heat maps of the densities p(y, t) and p(y', t) over time.
/// @pre the run has at least two snapshots
report::Figure transient_figure(const TransientRun& run);

/// Writes a density over time to a netCDF-4 file (HDF5) that follows the CF conventions:
///
///     dimensions   time, y, ydot, bounds = 2
///     coordinates  time(time), y(y), ydot(ydot): centres of cells; edges of cells in
///                  y_bounds(y, bounds), ydot_bounds(ydot, bounds)
///     marginals    p_y(time, y), p_ydot(time, ydot): averages over cells
///     over time    y1, y2, y4, v1, v2, v4 (moments as in summary.json), yv = E[y y'], energy,
///                  power, power_residual, impact_rate, mass, min_density
///
/// Global attributes of the netCDF file are command, case, options, initial state and status. All
/// quantities are non-dimensional. The netCDF file is either written completely or left unchanged.
/// @pre the run has at least one snapshot
/// @throws std::runtime_error with a message of one line if the file cannot be written
void write_transient_netcdf(const std::filesystem::path& file, const TransientRun& run);

/// Writes transient.nc, the script figures/transient-CASE.gp and the pictures of this script into a
/// prepared directory. After a failure an output file may be missing, but is never incomplete. An
/// output file of an earlier run of the case is removed if the new run has no data for the file.
/// @return warnings about pictures that could not be drawn, one line each
/// @throws std::runtime_error if a file cannot be written
std::vector<std::string> write_transient_files(const std::filesystem::path& directory,
                                               const TransientRun& run,
                                               const report::FigureOptions& figures = {},
                                               const std::string& gnuplot = "gnuplot");

/// A marginal density at several times.
struct MarginalDensityOverTime {
  std::vector<double> edges;  ///< increasing edges of cells
  std::vector<double> times = {};
  std::vector<const std::vector<double>*> averages = {};  ///< averages over cells at each time
};

/// Returns a heat map of a density over time.
/// @param symbol symbol of the variable, in gnuplot's enhanced text
/// @pre the density has at least two times
report::FigurePanel density_heat_map_panel(const MarginalDensityOverTime& density,
                                           const std::string& title, const std::string& symbol);

}  // namespace fpkcheck::study
