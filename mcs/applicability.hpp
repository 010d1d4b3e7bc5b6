#pragma once

#include <string>

#include "mcs/options.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::mcs {

/// Returns the reason, in one phrase, why Monte Carlo simulation does not support a problem; an
/// empty text for a supported problem.
std::string unsupported_reason(const problem::Problem& problem, const SimulationOptions& options);

/// Returns the reason why a simulation cannot estimate spectra, sensitivities and first passages of
/// a problem; an empty text for a supported problem. Unlike unsupported_reason(),
/// unsupported_functional_reason() returns a reason for every problem with inelastic collapse.
std::string unsupported_functional_reason(const problem::Problem& problem,
                                          const SimulationOptions& options);

/// Returns the reason why importance splitting cannot resolve the tails of the density; an empty
/// text if the energy of the oscillator rises at impulses only.
std::string unsupported_splitting_reason(const problem::Problem& problem,
                                         const SimulationOptions& options);

}  // namespace fpkcheck::mcs
