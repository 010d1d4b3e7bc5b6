#pragma once

#include <filesystem>

#include "base/mpi/ranks.hpp"
#include "workflows/sweep/execution/solve_plan.hpp"

/// Solves a plan on several MPI ranks. The first rank, the coordinator, writes the journal, assigns
/// the points to free threads (the longest expected point first) and solves points itself. The
/// other ranks, the workers, only solve. Each request of a worker has exactly one reply. If a rank
/// is lost, all ranks end; the journal remains.
namespace fpkcheck::sweep {

/// Runs the coordinator on the first rank: solves the remaining points together with the workers.
/// An exception on a thread or a rank ends the sweep after the points in progress, and is rethrown.
/// @param threads solver threads of this rank; 0 for one per processor that the rank owns
void lead(const Plan& plan, Progress& progress, base::Ranks& ranks, int threads);

/// Replaces run_coordinator on the first rank when it cannot begin: replies to the workers that
/// there are no points.
void dismiss(base::Ranks& ranks);

/// Runs a worker: solves the assigned points until none remain.
/// @param directory output directory for the marginal densities
void follow(const Plan& plan, const std::filesystem::path& directory, base::Ranks& ranks,
            int threads);

}  // namespace fpkcheck::sweep
