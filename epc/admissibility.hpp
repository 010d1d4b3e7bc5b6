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

/// Why a density on the half-plane that meets the moment equations is still not to be relied on;
/// empty when there is no objection:
///  - its mass, by a rule of its own, is not 1: moments and marginals would carry the error;
///  - too much of it lies where the confinement begins, or beyond: that shapes it;
///  - it is far from that of order n-2: the orders have not settled.
/// @param order n
std::string half_plane_objection(int order, const transform::Solution& solution,
                                 const Summary& summary);

}  // namespace fpkcheck::epc
