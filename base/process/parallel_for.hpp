#pragma once

#include <cstddef>
#include <functional>

namespace fpkcheck::base {

/// Returns the number `requested` of threads, or of available processors if `requested` is 0.
int resolve_thread_count(int requested);

/// Argument `thread_count` of parallel_for() for one thread on each available processor.
inline constexpr int kOneThreadPerProcessor = 0;

/// Calls work(0) .. work(count - 1) on several threads, including the calling thread. After an
/// exception in one call of the function `work`, no further call starts, and the first exception is
/// rethrown after all running calls have ended.
/// @param thread_count number of threads, or kOneThreadPerProcessor
void parallel_for(std::size_t count, int thread_count,
                  const std::function<void(std::size_t)>& work);

/// Returns the number of processors in the affinity mask of this process, at least 1.
/// SLURM_CPUS_PER_TASK and OMP_NUM_THREADS are upper limits of the number of processors. The
/// affinity mask excludes processors of a shared node that belong to other jobs.
int available_processors();

}  // namespace fpkcheck::base
