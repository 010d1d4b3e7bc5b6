#pragma once

namespace fpkcheck::base {

/// Number of processors available to this process, at least 1: the number of processors in the
/// affinity mask of the process (set by taskset, a container or a batch system), but at most
/// SLURM_CPUS_PER_TASK and OMP_NUM_THREADS if these variables are set. Other processors of a shared
/// node belong to other jobs and are not counted.
int available_processors();

}  // namespace fpkcheck::base
