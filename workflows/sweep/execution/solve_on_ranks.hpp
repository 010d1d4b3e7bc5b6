#pragma once

#include <filesystem>

#include "base/mpi/ranks.hpp"
#include "workflows/sweep/execution/solve_plan.hpp"

/// A plan on several processes: the first rank has the journal, hands out points to whoever is free,
/// the longest expected first, and solves beside that; the others only solve. Each question of theirs
/// has one answer. A rank that is lost ends all of them; the journal stays.
namespace fpkcheck::sweep {

/// What the first rank does: solves what is left, with the others' help. What a thread or a rank
/// throws ends the sweep, after what was under way.
/// @param threads of each rank; 0 for one per processor that is its own
void lead(const Plan& plan, Progress& progress, base::Ranks& ranks, int threads);

/// What the first rank does instead where it cannot begin: tells the others that there are no points.
void dismiss(base::Ranks& ranks);

/// What the other ranks do: solve the points they are given until there are no more.
/// @param directory for marginals
void follow(const Plan& plan, const std::filesystem::path& directory, base::Ranks& ranks,
            int threads);

}  // namespace fpkcheck::sweep
