#pragma once

#include <cstdint>
#include <vector>

#include "fd_fpk/operator/operator.hpp"

namespace fpkcheck::fd_fpk {

/// An ordering of the unknowns that reduces the number of new nonzeros in the factors, by nested
/// dissection of the graph of A + A^T (CHOLMOD with METIS). The ordering depends on the pattern of
/// the matrix alone. Recent orderings are cached, since the same grid sizes recur in error
/// estimates and at neighbouring points of a sweep. The function is thread-safe.
/// @return the ordering; empty on failure
std::vector<std::int64_t> fill_reducing_ordering(const SparseColumnMatrix& matrix);

}  // namespace fpkcheck::fd_fpk
