#pragma once

#include <complex>

#include "problem/impulse_law.hpp"

namespace fpkcheck::exact {

/// The characteristic function E[exp(i u Y)] of an amplitude law.
std::complex<double> characteristic_function(const problem::ImpulseLaw& law, double u);

/// The moment generating function E[exp(u Y)] of an amplitude law; infinite if the expectation does
/// not exist (for the Laplace law: |u| >= 1/scale).
double moment_generating_function(const problem::ImpulseLaw& law, double u);

}  // namespace fpkcheck::exact
