#include "workflows/sweep/execution/point_queue.hpp"

#include <algorithm>
#include <set>

namespace fpkcheck::sweep {
namespace {

// The number of points in the initial sample, and the smaller number of measured points that
// suffices to sort the other points. With the smaller number, no thread has to wait for the last
// point of the sample.
constexpr std::size_t kInitialSample = 24, kMinMeasurements = 16;

}  // namespace

PointQueue::PointQueue(const Plan& plan, const std::vector<std::size_t>& own_points,
                       const std::vector<PointResult>& solved)
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
  sort_if_enough_measured();
  if (!expected_.empty()) return;
  std::erase_if(waiting_,
                [&](std::size_t p) { return std::ranges::find(first, p) != first.end(); });
  waiting_.insert(waiting_.end(), first.rbegin(), first.rend());
}

std::optional<std::size_t> PointQueue::take_next_point() {
  const std::lock_guard lock(mutex_);
  if (waiting_.empty()) return std::nullopt;
  const std::size_t point = waiting_.back();
  waiting_.pop_back();
  return point;
}

void PointQueue::record_solved(std::size_t point, double seconds) {
  const std::lock_guard lock(mutex_);
  measured_.push_back({point, seconds});
  --unfinished_;
  if (expected_.empty()) {
    sort_if_enough_measured();
  } else {
    remaining_seconds_ = std::max(0.0, remaining_seconds_ - expected_[point]);
  }
}

void PointQueue::sort_if_enough_measured() {
  if (measured_.size() < kMinMeasurements) return;
  expected_ = CostModel(plan_, measured_).all_expected_seconds();
  std::ranges::stable_sort(waiting_, {}, [this](std::size_t p) { return expected_[p]; });
  for (const std::size_t p : waiting_) remaining_seconds_ += expected_[p];
}

PointQueue::State PointQueue::state() const {
  const std::lock_guard lock(mutex_);
  return {total_ - unfinished_, total_,
          expected_.empty() ? std::nullopt : std::optional(remaining_seconds_)};
}

}  // namespace fpkcheck::sweep
