#include "control_variates/control_variate_estimates.hpp"

#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <iterator>
#include <utility>

namespace fpkcheck::control_variates {
namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Table = Eigen::Map<const RowMajor>;

mcs::MeanEstimate mean_over_streams(const Eigen::VectorXd& values) {
  const auto n = static_cast<double>(values.size());
  const double mean = values.mean();
  return {mean, std::sqrt((values.array() - mean).square().sum() / (n - 1) / n)};
}

mcs::MeanEstimate scale_estimate(const mcs::MeanEstimate& e, double factor) {
  return {e.mean * factor, e.standard_error * factor};
}

/// Returns the contribution of each stream of the simulation to the sampling error of each mean.
/// The squared contributions of the streams to the sampling error, summed over all streams, give
/// the squared standard error.
Eigen::MatrixXd stream_error_contributions(const Eigen::MatrixXd& values) {
  const auto n = static_cast<double>(values.cols());
  return (values.colwise() - values.rowwise().mean()) / std::sqrt((n - 1) * n);
}

mcs::L1SamplingError l1_error_over_bins(const Eigen::MatrixXd& errors) {
  mcs::BinErrors bins;
  for (const auto& row : errors.rowwise()) bins.emplace_back(row.begin(), row.end());
  return mcs::l1_sampling_error(bins);
}

/// @param controlled, plain averages over bins of each stream with and without control variates,
///   shape (bins, streams)
SmoothBinAverageEstimates bin_estimates(const transform::SmoothBins& bins,
                                        const Eigen::MatrixXd& controlled,
                                        const Eigen::MatrixXd& plain) {
  const Eigen::MatrixXd errors = stream_error_contributions(controlled);
  SmoothBinAverageEstimates result{
      .bins = bins,
      .averages = {},
      .covariance = errors * errors.transpose(),
      .controlled_l1 = l1_error_over_bins(errors),
      .plain_l1 = l1_error_over_bins(stream_error_contributions(plain))};
  for (int b = 0; b < bins.count; ++b) {
    const double per_weight = 1 / transform::smooth_bin_weight(bins, b);
    result.averages.push_back({scale_estimate(mean_over_streams(controlled.row(b)), per_weight),
                               scale_estimate(mean_over_streams(plain.row(b)), per_weight)});
    result.covariance.row(b) *= per_weight;
    result.covariance.col(b) *= per_weight;
  }
  return result;
}

}  // namespace

Eigen::MatrixXd stream_means_of_generated_splines(
    const ControlVariateSetup& setup, std::span<const mcs::DepositedSumsOfTrajectory> streams) {
  const Eigen::Index ny = setup.deposit_layout.y.size(), nv = setup.deposit_layout.v.size();
  Eigen::MatrixXd means(ny * nv, static_cast<Eigen::Index>(streams.size()));
  RowMajor after_impulse = setup.after_impulse;
  RowMajor sums(ny, nv);
  for (std::size_t s = 0; s < streams.size(); ++s) {
    const mcs::DepositedSampleSums& d = streams[s].sums;
    sums = Table(d.flow.data(), ny, d.flow_pitch).leftCols(nv);
    sums.noalias() +=
        Table(d.lattice.data(), ny, d.lattice_pitch).leftCols(after_impulse.rows()) * after_impulse;
    means.col(static_cast<Eigen::Index>(s)) =
        Eigen::Map<const Eigen::VectorXd>(sums.data(), sums.size()) / streams[s].samples;
  }
  return means;
}

StationaryFunctionalEstimates estimate_functionals(
    const ControlVariateSetup& setup, const Eigen::MatrixXd& generator,
    std::span<const mcs::DepositedSumsOfTrajectory> streams) {
  const EstimatedFunctionals& functionals = setup.deposit_layout.functionals;
  Eigen::MatrixXd plain(functionals.functional_count(), generator.cols());
  for (std::size_t s = 0; s < streams.size(); ++s) {
    const std::vector<double> means = functionals.functional_means_in_stream(streams[s]);
    plain.col(static_cast<Eigen::Index>(s)) =
        Eigen::Map<const Eigen::VectorXd>(means.data(), plain.rows());
  }
  const Eigen::MatrixXd controlled = plain + setup.control.transpose() * generator;
  std::vector<EstimatesWithAndWithoutControlVariates> moments;
  for (Eigen::Index f = 0; f < std::ssize(kMoments); ++f) {
    moments.push_back({mean_over_streams(controlled.row(f)), mean_over_streams(plain.row(f))});
  }
  const auto bins = [&](const transform::SmoothBins& of, Eigen::Index first) {
    return bin_estimates(of, controlled.middleRows(first, of.count),
                         plain.middleRows(first, of.count));
  };
  const boost::math::students_t student(static_cast<double>(streams.size() - 1));
  return {.moments = std::move(moments),
          .y = bins(functionals.y_bins, std::ssize(kMoments)),
          .v = bins(functionals.v_bins, std::ssize(kMoments) + functionals.y_bins.count),
          .confidence_interval_factor = boost::math::quantile(student, 0.975)};
}

}  // namespace fpkcheck::control_variates
