#pragma once

#include <cstddef>
#include <functional>

namespace fpkcheck::methods {

/// The number of threads for a request: `requested`, or one per processor for 0.
int number_of_threads(int requested);

/// Calls work(0) .. work(count - 1) on several threads. After an exception, no further call starts;
/// the first exception is rethrown when all started calls have ended.
/// @param threads 0 for one per processor
void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& work);

}  // namespace fpkcheck::methods
