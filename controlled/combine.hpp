#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "controlled/prepared.hpp"
#include "mcs/estimate/estimate.hpp"
#include "mcs/summary.hpp"

namespace fpkcheck::controlled {

/// An expectation with the noise taken out, and as the samples have it.
struct Estimated {
  mcs::Estimate controlled, plain;
};

/// A density in smooth bins: averages of p(x) weighted by M((x - first)/spacing - b).
struct SmoothBins {
  mcs::CubicBins bins;
  std::vector<Estimated> averages;
  /// The L1 distance that chance explains, sum sqrt(2/pi) (standard error) (weight of the bin).
  double controlled_l1 = 0, plain_l1 = 0;
};

struct Estimates {
  std::vector<Estimated> moments;  ///< in the order of kMoments
  SmoothBins y, v;
  /// Half the width of a 95 % interval in standard errors (Student's).
  double interval_factor = 0;
};

/// The means of L A_i B_j of each stream, impacts included, shape (functions, streams), a function
/// in row i * v.size() + j.
Eigen::MatrixXd mean_generator(const Prepared& prepared,
                               std::span<const mcs::StreamDeposit> streams);

/// E[f] = mean of (f + L h), for every functional. Unbiased whatever h is; standard errors from the
/// differences between streams.
Estimates combine(const Prepared& prepared, const Eigen::MatrixXd& generator,
                  std::span<const mcs::StreamDeposit> streams);

}  // namespace fpkcheck::controlled
