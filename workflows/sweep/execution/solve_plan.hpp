#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "workflows/sweep/execution/queue.hpp"
#include "workflows/sweep/execution/shard.hpp"
#include "workflows/sweep/execution/solve_point.hpp"
#include "workflows/sweep/plan/plan.hpp"
#include "workflows/sweep/result/journal.hpp"

namespace fpkcheck::sweep {

/// Told where a sweep stands; called from several threads, never two at once. What it throws ends the
/// sweep.
using StandingListener = std::function<void(const Queue::Standing&)>;

/// The journal of a sweep and the points that it lacks: what is solved goes into the first and out of
/// the second. May be asked from several threads.
class Progress {
 public:
  /// Opens the journal in the directory, or begins one.
  /// @throws what Journal's constructor throws
  Progress(const Plan& plan, const std::filesystem::path& directory, const Shard& shard,
           StandingListener listener);

  /// The next point to solve; nothing when there is none, or when the program was told to stop.
  std::optional<std::size_t> next();
  /// Keeps what became of it.
  void keep(SolvedPoint&& solved);

  Queue::Standing standing() const { return queue_.standing(); }
  /// One line for a sweep that resumes: how many points it keeps, how many it solves, and which of
  /// these again; empty where the journal is new.
  std::string resumed_text() const;
  /// All that is there, those of before first.
  std::vector<PointResult> points() const { return points_; }

 private:
  const Plan& plan_;
  std::filesystem::path directory_;
  std::string journal_name_;
  Journal journal_;
  Queue queue_;
  StandingListener listener_;
  std::mutex mutex_;
  std::vector<PointResult> points_;
};

/// Writes the marginals of a point, where there are any, to marginals/NUMBER.csv.
/// @throws std::runtime_error on one line
void keep_marginals(const Plan& plan, const std::filesystem::path& directory,
                    const SolvedPoint& solved);

/// Solves what is left by so many threads, one point each at a time.
/// @param threads 0 for one per processor
void solve_left(const Plan& plan, Progress& progress, int threads);

}  // namespace fpkcheck::sweep
