#pragma once

#include <cstdint>
#include <vector>

#include "fd_fpk/operator/operator.hpp"

namespace fpkcheck::fd_fpk {

/// An order of unknowns in which a factorisation of the matrix has few entries, by nested dissection
/// of the graph of A + A^T (CHOLMOD with METIS). It follows from the pattern alone; the orders of the
/// last patterns are kept, since grids of one size come again: coarser ones for an estimate of the
/// error, neighbours of a sweep. May be called from several threads.
/// @return empty when there is none
std::vector<std::int64_t> ordering(const SparseColumns& matrix);

}  // namespace fpkcheck::fd_fpk
