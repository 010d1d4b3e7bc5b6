#include "controlled/combine.hpp"

#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <numbers>

namespace fpkcheck::controlled {
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

/// @param all of the bins' functionals
/// @param from where the variable begins
SmoothBins smooth_bins(const mcs::CubicBins& bins, std::span<const Estimated> all, double from) {
  SmoothBins result{.bins = bins, .averages = {}};
  const double factor = std::sqrt(2 / std::numbers::pi);
  for (int b = 0; b < bins.count; ++b) {
    const auto& [controlled, plain] = all[static_cast<std::size_t>(b)];
    const double weight = bin_weight(bins, b, from);
    result.averages.push_back({scaled(controlled, 1 / weight), scaled(plain, 1 / weight)});
    result.controlled_l1 += factor * controlled.standard_error;
    result.plain_l1 += factor * plain.standard_error;
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
  std::vector<Estimated> all;
  for (Eigen::Index f = 0; f < plain.rows(); ++f) {
    all.push_back({over_streams(controlled.row(f)), over_streams(plain.row(f))});
  }
  const std::span<const Estimated> bins = std::span(all).subspan(kMoments.size());
  const auto y_bins = static_cast<std::size_t>(functionals.y_bins.count);
  const boost::math::students_t student(static_cast<double>(streams.size() - 1));
  return {.moments = {all.begin(), all.begin() + kMoments.size()},
          .y = smooth_bins(functionals.y_bins, bins.first(y_bins), 0),
          .v = smooth_bins(functionals.v_bins, bins.subspan(y_bins),
                           -std::numeric_limits<double>::infinity()),
          .interval_factor = boost::math::quantile(student, 0.975)};
}

}  // namespace fpkcheck::controlled
