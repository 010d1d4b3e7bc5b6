#pragma once

#include <optional>

#include "epc/polynomial.hpp"
#include "epc/solve.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::epc {

/// Judges a root of (23): C exp(Q_n) restricted to its support, its moments, its energy balance.
/// @param previous the root of order n-2, to compare with
/// Fills the result's density and everything that is said about it, the status ok or inadmissible
/// among it.
void judge(const problem::Problem& problem, const Polynomial& q,
           const std::optional<Polynomial>& previous, Result& result);

}  // namespace fpkcheck::epc
