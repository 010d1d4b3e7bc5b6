#pragma once

#include <filesystem>

#include "base/mpi/communicator.hpp"
#include "workflows/sweep/execution/solve_plan.hpp"

/// Solves a plan on several MPI ranks. The first rank, the coordinator, writes the journal, assigns
/// the points to free threads (the longest expected point first) and solves points itself. The
/// other ranks, the workers, only solve. Each request of a worker has exactly one reply. If a rank
/// is lost, all ranks end; the journal remains.
namespace fpkcheck::sweep {

/// Runs the coordinator on the first rank: solves the remaining points together with the workers.
/// An exception on a thread or a rank ends the sweep after the points in progress, and is rethrown.
/// @param threads solver threads of this rank; 0 for one per processor that the rank owns
void run_coordinator(const Plan& plan, JournaledQueue& progress, base::Communicator& ranks,
                     int threads);

/// Replaces run_coordinator on the first rank when it cannot begin: replies to the workers that
/// there are no points.
void release_workers(base::Communicator& ranks);

/// Runs a worker: solves the assigned points until none remain.
/// @param directory output directory for the marginal densities
void run_worker(const Plan& plan, const std::filesystem::path& directory, base::Communicator& ranks,
                int threads);

}  // namespace fpkcheck::sweep
