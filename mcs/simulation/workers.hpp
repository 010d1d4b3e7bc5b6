#pragma once

#include <cstddef>
#include <functional>
#include <optional>

namespace fpkcheck::mcs {

/// As many threads as asked for, or one per processor of this process.
int number_of_threads(const std::optional<int>& asked);

/// Does work(0), .., work(shares - 1), each once, by as many threads as given, and returns when all
/// is done. After an exception no further share is begun; it leaves this function.
void share_work(int threads, std::size_t shares, const std::function<void(std::size_t)>& work);

}  // namespace fpkcheck::mcs
