#pragma once

#include <string>

#include "mcs/options.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::mcs {

/// Returns in one phrase why the simulation does not support a problem; empty for a supported
/// problem.
std::string unsupported_reason(const problem::Problem& problem, const SimulationOptions& options);

/// Returns why a simulation does not give spectra, sensitivities and passages of a problem; empty
/// for a supported problem. In contrast to unsupported_reason(), this function reports every
/// inelastic collapse as unsupported.
std::string unsupported_functional_reason(const problem::Problem& problem,
                                          const SimulationOptions& options);

/// Returns why importance splitting does not resolve the tails of the density; empty if the energy
/// rises at impulses only.
std::string unsupported_splitting_reason(const problem::Problem& problem,
                                         const SimulationOptions& options);

}  // namespace fpkcheck::mcs
