#pragma once

#include <filesystem>
#include <functional>

#include "base/mpi/communicator.hpp"
#include "workflows/sweep/execution/point_queue.hpp"
#include "workflows/sweep/plan/plan.hpp"

namespace fpkcheck::sweep {

/// Solves all points that a source returns. Each thread solves one point at a time. After an
/// exception on a thread, the points in progress are completed, and the exception is rethrown.
/// @param threads number of threads; 0 for one thread per processor
void solve_remaining_points(const SweepPlan& plan, PointSource& points, int threads);

/// Solves the remaining points of a plan on the threads of this process or of all MPI ranks. Under
/// MPI each rank calls solve_plan(). The first rank, the coordinator, writes the journal, assigns
/// points to free threads by decreasing expected time, and also solves points. All further ranks,
/// the workers, only solve points. After an exception on a thread or a rank, the points in progress
/// are completed, and the exception is rethrown.
/// @param directory output directory for the marginal densities
/// @param ranks communicator of the MPI ranks; null without MPI
/// @param threads number of threads of this rank; 0 for one thread per processor of the rank
/// @param open_queue function that opens the journal, called only on the first rank. If
/// open_queue() throws an exception, the workers end.
void solve_plan(const SweepPlan& plan, const std::filesystem::path& directory,
                base::Communicator* ranks, int threads,
                const std::function<JournaledPointQueue&()>& open_queue);

}  // namespace fpkcheck::sweep
