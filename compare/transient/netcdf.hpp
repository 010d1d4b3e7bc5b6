#pragma once

#include <filesystem>

#include "compare/transient/run.hpp"

namespace fpkcheck::compare {

/// Writes a density over time as netCDF-4 (an HDF5 file), following the CF conventions:
///
///     dimensions   time, y, ydot, bounds = 2
///     coordinates  time(time), y(y), ydot(ydot): centres of cells; their edges are in
///                  y_bounds(y, bounds), ydot_bounds(ydot, bounds)
///     marginals    p_y(time, y), p_ydot(time, ydot): averages over cells
///     over time    y1, y2, y4, v1, v2, v4 (moments as in summary.json), energy, power,
///                  power_residual, impact_rate, mass, min_density
///
/// The global attributes hold the command, the case, the options, the start and the status. All is
/// non-dimensional. The file is either whole or as it was.
/// @param run with at least one snapshot
/// @throws std::runtime_error on one line when it cannot be written
void write_transient_netcdf(const std::filesystem::path& file, const TransientRun& run);

}  // namespace fpkcheck::compare
