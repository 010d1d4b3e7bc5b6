#include "control_variates/combine.hpp"

#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <iterator>
#include <utility>

namespace fpkcheck::control_variates {
namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Table = Eigen::Map<const RowMajor>;

mcs::Estimate over_streams(const Eigen::VectorXd& values) {
  const auto n = static_cast<double>(values.size());
  const double mean = values.mean();
  return {mean, std::sqrt((values.array() - mean).square().sum() / (n - 1) / n)};
}

mcs::Estimate scaled(const mcs::Estimate& e, double factor) {
  return {e.mean * factor, e.standard_error * factor};
}

/// Error contribution of each stream to the means; the sum of squares over streams is SE^2.
Eigen::MatrixXd errors_of(const Eigen::MatrixXd& values) {
  const auto n = static_cast<double>(values.cols());
  return (values.colwise() - values.rowwise().mean()) / std::sqrt((n - 1) * n);
}

mcs::SamplingL1 sampling_of(const Eigen::MatrixXd& errors) {
  mcs::BinErrors bins;
  for (const auto& row : errors.rowwise()) bins.emplace_back(row.begin(), row.end());
  return mcs::sampling_l1(bins);
}

/// @param controlled means of the bins in each stream, shape (bins, streams); `plain` likewise
BinEstimates bin_estimates(const transform::SmoothBins& bins, const Eigen::MatrixXd& controlled,
                           const Eigen::MatrixXd& plain) {
  const Eigen::MatrixXd errors = errors_of(controlled);
  BinEstimates result{.bins = bins,
                      .averages = {},
                      .covariance = errors * errors.transpose(),
                      .controlled_l1 = sampling_of(errors),
                      .plain_l1 = sampling_of(errors_of(plain))};
  for (int b = 0; b < bins.count; ++b) {
    const double per_weight = 1 / transform::bin_weight(bins, b);
    result.averages.push_back({scaled(over_streams(controlled.row(b)), per_weight),
                               scaled(over_streams(plain.row(b)), per_weight)});
    result.covariance.row(b) *= per_weight;
    result.covariance.col(b) *= per_weight;
  }
  return result;
}

}  // namespace

Eigen::MatrixXd mean_generator(const Prepared& prepared,
                               std::span<const mcs::StreamDeposit> streams) {
  const Eigen::Index ny = prepared.places.y.size(), nv = prepared.places.v.size();
  Eigen::MatrixXd means(ny * nv, static_cast<Eigen::Index>(streams.size()));
  RowMajor after_impulse = prepared.after_impulse;
  RowMajor sums(ny, nv);
  for (std::size_t s = 0; s < streams.size(); ++s) {
    const mcs::Deposit& d = streams[s].sums;
    sums = Table(d.flow.data(), ny, d.flow_pitch).leftCols(nv);
    sums.noalias() +=
        Table(d.lattice.data(), ny, d.lattice_pitch).leftCols(after_impulse.rows()) * after_impulse;
    means.col(static_cast<Eigen::Index>(s)) =
        Eigen::Map<const Eigen::VectorXd>(sums.data(), sums.size()) / streams[s].samples;
  }
  return means;
}

Estimates combine(const Prepared& prepared, const Eigen::MatrixXd& generator,
                  std::span<const mcs::StreamDeposit> streams) {
  const Functionals& functionals = prepared.places.functionals;
  Eigen::MatrixXd plain(functionals.size(), generator.cols());
  for (std::size_t s = 0; s < streams.size(); ++s) {
    const std::vector<double> means = functionals.means(streams[s]);
    plain.col(static_cast<Eigen::Index>(s)) =
        Eigen::Map<const Eigen::VectorXd>(means.data(), plain.rows());
  }
  const Eigen::MatrixXd controlled = plain + prepared.control.transpose() * generator;
  std::vector<Estimated> moments;
  for (Eigen::Index f = 0; f < std::ssize(kMoments); ++f) {
    moments.push_back({over_streams(controlled.row(f)), over_streams(plain.row(f))});
  }
  const auto bins = [&](const transform::SmoothBins& of, Eigen::Index first) {
    return bin_estimates(of, controlled.middleRows(first, of.count),
                         plain.middleRows(first, of.count));
  };
  const boost::math::students_t student(static_cast<double>(streams.size() - 1));
  return {.moments = std::move(moments),
          .y = bins(functionals.y_bins, std::ssize(kMoments)),
          .v = bins(functionals.v_bins, std::ssize(kMoments) + functionals.y_bins.count),
          .interval_factor = boost::math::quantile(student, 0.975)};
}

}  // namespace fpkcheck::control_variates
