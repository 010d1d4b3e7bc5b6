#include "workflows/sweep/execution/solve_plan.hpp"

#include <fmt/format.h>

#include <sstream>
#include <utility>

#include "base/files/pending_files.hpp"
#include "base/process/exit_blocker.hpp"
#include "base/process/parallel_for.hpp"
#include "base/process/stop_request.hpp"
#include "base/text/sanitise.hpp"
#include "results/marginals_csv.hpp"

namespace fpkcheck::sweep {
void write_marginals(const Plan& plan, const std::filesystem::path& directory,
                     const SolvedPoint& solved) {
  if (solved.curves.empty()) return;
  const base::ExitBlocker in_hand;
  std::filesystem::create_directories(directory / "marginals");
  const std::vector<results::CaseResult> cases{{.problem = plan.problem_at(solved.result.point),
                                                .solutions = {},
                                                .pairs = {},
                                                .budget = {},
                                                .limits = {},
                                                .curves = solved.curves,
                                                .joints = {}}};
  std::ostringstream text;
  results::write_marginals_csv(text, cases);
  base::write_file(directory / "marginals" / fmt::format("{:06}.csv", solved.result.point),
                   text.str());
}

JournaledQueue::JournaledQueue(const Plan& plan, const std::filesystem::path& directory,
                               const Shard& shard, QueueStateListener listener)
    : plan_(plan),
      directory_(directory),
      journal_name_(shard.journal_name()),
      journal_(directory / journal_name_, plan),
      queue_(plan, shard.points(plan.points.size()), journal_.initial_content().points),
      listener_(std::move(listener)),
      points_(journal_.initial_content().points) {}

std::string JournaledQueue::resumption_text() const {
  const auto& [plan, points, damaged] = journal_.initial_content();
  if (points.empty() && damaged == 0) return "";
  const auto [done, total, remaining_seconds] = queue_.state();
  std::string text =
      fmt::format("resumed from {}: {} of {} points kept, {} to solve",
                  base::sanitise((directory_ / journal_name_).string()), done, total, total - done);
  // A damaged line of the journal does not show which point the line contains.
  if (damaged == 1) text += ", including the point of 1 damaged line";
  if (damaged > 1) text += fmt::format(", including the points of {} damaged lines", damaged);
  return text;
}

std::optional<std::size_t> JournaledQueue::take_next_point() {
  if (base::stop_requested()) return std::nullopt;
  return queue_.take_next_point();
}

void JournaledQueue::store(SolvedPoint&& solved) {
  queue_.record_solved(solved.result.point, solved.result.seconds);
  const std::lock_guard lock(mutex_);
  // The marginal densities must exist before the journal lists the point as solved.
  write_marginals(plan_, directory_, solved);
  journal_.append(solved.result);
  points_.push_back(std::move(solved.result));
  if (listener_) listener_(queue_.state());
}

void solve_remaining_points(const Plan& plan, JournaledQueue& progress, int threads) {
  const int thread_count = base::number_of_threads(threads);
  base::parallel_for(static_cast<std::size_t>(thread_count), thread_count, [&](std::size_t) {
    for (auto point = progress.take_next_point(); point; point = progress.take_next_point()) {
      progress.store(solve_point(plan, *point));
    }
  });
}

}  // namespace fpkcheck::sweep
