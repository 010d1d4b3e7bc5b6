#pragma once

#include <cstddef>
#include <functional>

namespace fpkcheck::methods {

/// As many threads as asked for; for 0 one per processor.
int number_of_threads(int asked);

/// Does work(0) .. work(count - 1) on several threads; rethrows the first exception when all that
/// had begun has ended, and begins no more after it.
/// @param threads 0 for one per processor
void side_by_side(std::size_t count, int threads, const std::function<void(std::size_t)>& work);

}  // namespace fpkcheck::methods
