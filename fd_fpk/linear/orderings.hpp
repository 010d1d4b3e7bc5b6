#pragma once

#include <cstdint>
#include <vector>

#include "fd_fpk/operator/operator.hpp"

namespace fpkcheck::fd_fpk {

/// A fill-reducing ordering of the unknowns for a factorisation, by nested dissection of the graph
/// of A + A^T (CHOLMOD with METIS). It depends on the pattern of the matrix alone. Recent orderings
/// are cached, since grids of one size recur: coarser grids of an error estimate, neighbours in a
/// sweep. Thread-safe.
/// @return empty on failure
std::vector<std::int64_t> ordering(const SparseColumns& matrix);

}  // namespace fpkcheck::fd_fpk
