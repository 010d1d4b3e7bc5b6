#pragma once

#include "problem/problem.hpp"
#include "results/netcdf/writer.hpp"

namespace fpkcheck::results {

/// Writes the parameters of a problem as attributes of a variable, or of the file: `damping`, ..,
/// `impulse_rate`, `impulse_law`, ..
void write_parameters(NetCdfWriter& file, const problem::Problem& problem,
                      int variable = NetCdfWriter::kGlobal);

}  // namespace fpkcheck::results
