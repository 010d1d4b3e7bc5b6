#pragma once

namespace fpkcheck::base {

/// Number of processors available to this process, at least 1: those of its affinity mask (taskset,
/// container, batch system), limited by SLURM_CPUS_PER_TASK and OMP_NUM_THREADS where they are set.
/// Other processors of a shared node belong to other jobs and do not count.
int processors();

}  // namespace fpkcheck::base
