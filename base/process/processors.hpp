#pragma once

namespace fpkcheck::base {

/// How many processors are this process's own: those that it may run on (its affinity: taskset, a
/// container, a batch system), and no more than SLURM_CPUS_PER_TASK and OMP_NUM_THREADS say where
/// they are set. At least 1. The processors of the node do not count: on a shared one they are
/// others'.
int processors();

}  // namespace fpkcheck::base
