#pragma once

#include <cstddef>
#include <mutex>
#include <optional>
#include <vector>

#include "workflows/sweep/execution/cost_model.hpp"
#include "workflows/sweep/plan/plan.hpp"
#include "workflows/sweep/result/point_result.hpp"

namespace fpkcheck::sweep {

/// The points that are to be solved, handed out one by one: first a few from everywhere, and once
/// these tell how long points take, the longest expected first, so that none is begun when all
/// others are done. May be asked from several threads.
class Queue {
 public:
  /// Where it stands.
  struct Standing {
    std::size_t done = 0, total = 0;  ///< of the points that are this queue's
    /// Seconds of all solves that are left; nothing as long as too little is known.
    std::optional<double> left = {};
  };

  /// @param own the points that are this queue's, in increasing order
  /// @param solved before; those of others among them tell how long points take
  Queue(const Plan& plan, const std::vector<std::size_t>& own,
        const std::vector<PointResult>& solved);

  /// @return nothing when there is none left
  std::optional<std::size_t> next();
  /// To be told of every point that was solved.
  void finished(std::size_t point, double seconds);

  Standing standing() const;

 private:
  void order_if_enough_is_known();

  const Plan& plan_;
  mutable std::mutex mutex_;
  std::size_t total_;
  std::vector<CostModel::Measured> measured_;
  std::vector<std::size_t> waiting_;  // the next one last
  std::vector<double> expected_;      // empty until enough is known
  std::size_t unfinished_;
  double left_ = 0;
};

}  // namespace fpkcheck::sweep
