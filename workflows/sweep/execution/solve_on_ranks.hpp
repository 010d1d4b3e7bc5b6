#pragma once

#include <filesystem>

#include "base/mpi/communicator.hpp"
#include "workflows/sweep/execution/solve_plan.hpp"

/// Solves a plan on several MPI ranks. The first rank, the coordinator, writes the journal, assigns
/// points to free threads (by decreasing expected time) and also solves points. The other ranks,
/// the workers, only solve points. Each request of a worker has exactly one reply. If a rank fails,
/// all ranks end; the journal remains.
namespace fpkcheck::sweep {

/// Runs the coordinator on the first rank: solves the remaining points together with the workers.
/// After an exception on a thread or a rank, the points in progress are completed; then the sweep
/// ends and the exception is rethrown.
/// @param threads number of solver threads of this rank; 0 for one thread per processor of the rank
void run_coordinator(const Plan& plan, JournaledQueue& progress, base::Communicator& ranks,
                     int threads);

/// Releases the workers if the first rank cannot call run_coordinator: replies to each worker that
/// no points remain.
void release_workers(base::Communicator& ranks);

/// Runs a worker: solves the assigned points until none remain.
/// @param directory output directory for the marginal densities
void run_worker(const Plan& plan, const std::filesystem::path& directory, base::Communicator& ranks,
                int threads);

}  // namespace fpkcheck::sweep
