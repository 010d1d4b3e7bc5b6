#pragma once

#include <cstddef>
#include <functional>

namespace fpkcheck::base {

/// The number of threads to use: `requested`, or one thread per processor if `requested` is 0.
int number_of_threads(int requested);

/// Calls work(0) .. work(count - 1) on several threads, of which the calling thread is one. After
/// an exception of a call, no further call starts. The first exception is rethrown after all
/// started calls have ended.
/// @param thread_count number of threads; 0 for one per processor
void parallel_for(std::size_t count, int thread_count,
                  const std::function<void(std::size_t)>& work);

/// Number of processors available to this process, at least 1: the number of processors in the
/// affinity mask of the process (set by taskset, a container or a batch system), but at most
/// SLURM_CPUS_PER_TASK and OMP_NUM_THREADS if these variables are set. Other processors of a shared
/// node belong to other jobs and are not counted.
int available_processors();

}  // namespace fpkcheck::base
