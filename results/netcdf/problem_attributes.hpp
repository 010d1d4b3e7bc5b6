#pragma once

#include "problem/problem.hpp"
#include "results/netcdf/writer.hpp"

namespace fpkcheck::results {

/// Writes the parameters of a problem as netCDF attributes: `damping`, .., `impulse_rate`,
/// `impulse_law`, ..
/// @param variable id of the variable that gets the attributes, or kGlobal for the file
void write_problem_attributes(NetCdfWriter& file, const problem::Problem& problem,
                              int variable = NetCdfWriter::kGlobal);

}  // namespace fpkcheck::results
