#include "workflows/sweep/execution/solve_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/process/stop_request.hpp"
#include "base/text/printable_text.hpp"

namespace fpkcheck::sweep {
namespace {

// The queue of sweep points is sorted after kMinMeasurements measured points, so that no thread
// waits for the last point of the initial sample.
constexpr std::size_t kInitialSample = 24, kMinMeasurements = 16;

}  // namespace

SweepPointQueue::SweepPointQueue(const SweepPlan& plan, const std::vector<std::size_t>& own_points,
                                 const std::vector<SweepPointResult>& solved)
    : plan_(plan), total_(own_points.size()) {
  std::set<std::size_t> known;
  for (const auto& one : solved) {
    known.insert(one.point);
    measured_.push_back({one.point, one.seconds});
  }
  for (const std::size_t p : own_points) {
    if (!known.contains(p)) waiting_.push_back(p);
  }
  unfinished_ = waiting_.size();
  const auto first = evenly_spread_sample(waiting_, kInitialSample);
  std::ranges::reverse(waiting_);
  sort_by_time_if_enough_measured();
  if (!expected_.empty()) return;
  std::erase_if(waiting_,
                [&](std::size_t p) { return std::ranges::find(first, p) != first.end(); });
  waiting_.insert(waiting_.end(), first.rbegin(), first.rend());
}

std::optional<std::size_t> SweepPointQueue::take_next_sweep_point() {
  const std::lock_guard lock(mutex_);
  if (waiting_.empty()) return std::nullopt;
  const std::size_t point = waiting_.back();
  waiting_.pop_back();
  return point;
}

void SweepPointQueue::record_sweep_point_solve_time(std::size_t point, double seconds) {
  const std::lock_guard lock(mutex_);
  measured_.push_back({point, seconds});
  --unfinished_;
  if (expected_.empty()) {
    sort_by_time_if_enough_measured();
  } else {
    remaining_seconds_ = std::max(0.0, remaining_seconds_ - expected_[point]);
  }
}

void SweepPointQueue::sort_by_time_if_enough_measured() {
  if (measured_.size() < kMinMeasurements) return;
  expected_ = SolveTimeModel(plan_, measured_).all_expected_seconds();
  std::ranges::stable_sort(waiting_, {}, [this](std::size_t p) { return expected_[p]; });
  for (const std::size_t p : waiting_) remaining_seconds_ += expected_[p];
}

SweepPointQueue::State SweepPointQueue::point_queue_state() const {
  const std::lock_guard lock(mutex_);
  return {total_ - unfinished_, total_,
          expected_.empty() ? std::nullopt : std::optional(remaining_seconds_)};
}

JournaledPointQueue::JournaledPointQueue(const SweepPlan& plan,
                                         const std::filesystem::path& directory,
                                         const SweepShard& shard, QueueStateListener listener)
    : plan_(plan),
      directory_(directory),
      journal_name_(shard.shard_journal_name()),
      journal_(directory / journal_name_, plan),
      queue_(plan, shard.shard_point_numbers(plan.points.size()),
             journal_.initial_journal_content().points),
      listener_(std::move(listener)),
      points_(journal_.initial_journal_content().points) {}

std::string JournaledPointQueue::sweep_resumption_text() const {
  const auto& [plan, points, damaged] = journal_.initial_journal_content();
  if (points.empty() && damaged == 0) return "";
  const auto [done, total, remaining_seconds] = queue_.point_queue_state();
  std::string text = fmt::format("resumed from {}: {} of {} points kept, {} to solve",
                                 base::to_printable_text((directory_ / journal_name_).string()),
                                 done, total, total - done);
  // A damaged line of the journal does not show the sweep point to which the line belongs.
  if (damaged == 1) text += ", including the point of 1 damaged line";
  if (damaged > 1) text += fmt::format(", including the points of {} damaged lines", damaged);
  return text;
}

std::optional<std::size_t> JournaledPointQueue::take_next_sweep_point() {
  if (closed_ || base::stop_requested()) return std::nullopt;
  return queue_.take_next_sweep_point();
}

void JournaledPointQueue::store_solved_point(SolvedSweepPoint&& solved) {
  queue_.record_sweep_point_solve_time(solved.result.point, solved.result.seconds);
  const std::lock_guard lock(mutex_);
  // The marginal densities must be written before the journal lists the sweep point as solved.
  write_marginals(plan_, directory_, solved);
  journal_.append(solved.result);
  points_.push_back(std::move(solved.result));
  if (listener_) listener_(queue_.point_queue_state());
}

}  // namespace fpkcheck::sweep
