#pragma once

#include <cstddef>
#include <functional>
#include <optional>

namespace fpkcheck::mcs {

/// The requested number of threads, or one per available processor.
int number_of_threads(const std::optional<int>& requested);

/// Calls work(0), .., work(shares - 1) once each, in `threads` threads, and returns when all are
/// done. After an exception no further call starts, and the exception leaves this function.
void parallel_for(int threads, std::size_t shares, const std::function<void(std::size_t)>& work);

}  // namespace fpkcheck::mcs
