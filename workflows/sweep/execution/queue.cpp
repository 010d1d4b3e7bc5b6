#include "workflows/sweep/execution/queue.hpp"

#include <algorithm>
#include <set>

namespace fpkcheck::sweep {
namespace {

// Points of the initial sample, and measured points that suffice to sort the others. Fewer suffice,
// so that no thread waits for the last point of the sample.
constexpr std::size_t kFirst = 24, kEnough = 16;

}  // namespace

Queue::Queue(const Plan& plan, const std::vector<std::size_t>& own,
             const std::vector<PointResult>& solved)
    : plan_(plan), total_(own.size()) {
  std::set<std::size_t> known;
  for (const auto& one : solved) {
    known.insert(one.point);
    measured_.push_back({one.point, one.seconds});
  }
  for (const std::size_t p : own) {
    if (!known.contains(p)) waiting_.push_back(p);
  }
  unfinished_ = waiting_.size();
  const auto first = spread(waiting_, kFirst);
  std::ranges::reverse(waiting_);
  order_if_enough_is_known();
  if (!expected_.empty()) return;
  std::erase_if(waiting_,
                [&](std::size_t p) { return std::ranges::find(first, p) != first.end(); });
  waiting_.insert(waiting_.end(), first.rbegin(), first.rend());
}

std::optional<std::size_t> Queue::next() {
  const std::lock_guard lock(mutex_);
  if (waiting_.empty()) return std::nullopt;
  const std::size_t point = waiting_.back();
  waiting_.pop_back();
  return point;
}

void Queue::finished(std::size_t point, double seconds) {
  const std::lock_guard lock(mutex_);
  measured_.push_back({point, seconds});
  --unfinished_;
  if (expected_.empty()) {
    order_if_enough_is_known();
  } else {
    left_ = std::max(0.0, left_ - expected_[point]);
  }
}

void Queue::order_if_enough_is_known() {
  if (measured_.size() < kEnough) return;
  expected_ = CostModel(plan_, measured_).all();
  std::ranges::stable_sort(waiting_, {}, [this](std::size_t p) { return expected_[p]; });
  for (const std::size_t p : waiting_) left_ += expected_[p];
}

Queue::Standing Queue::standing() const {
  const std::lock_guard lock(mutex_);
  return {total_ - unfinished_, total_, expected_.empty() ? std::nullopt : std::optional(left_)};
}

}  // namespace fpkcheck::sweep
