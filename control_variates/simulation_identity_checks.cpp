#include "control_variates/simulation_identity_checks.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <boost/math/distributions/fisher_f.hpp>
#include <cmath>
#include <utility>

namespace fpkcheck::control_variates {
namespace {

constexpr double kSignificanceLevel = 1e-4;
// Quantile of the standard normal law at the two-sided significance level 1e-4.
constexpr double kNormalQuantile = 3.9;
// Limit of the errors of the force balance relative to the damping force, larger than the
// truncation error of the Taylor polynomials of free flights.
constexpr double kFlightTolerance = 1e-5;
constexpr double kRounding = 1e-12;

// Sums over all streams of the deposited sums and of the number of samples.
struct DepositedSumsOverTrajectories {
  double samples = 0, time = 0, impacts = 0;
  std::array<double, mcs::kRecordedMomentPowers.size()> powers{};
  std::array<double, 3> acceleration{}, wall{}, impulses{};

  explicit DepositedSumsOverTrajectories(std::span<const mcs::DepositedSumsOfTrajectory> streams) {
    const auto add = [](auto& to, const auto& what) {
      for (std::size_t k = 0; k < to.size(); ++k) to[k] += what[k];
    };
    for (const auto& stream : streams) {
      samples += stream.samples;
      time += stream.time;
      impacts += stream.impacts;
      add(powers, stream.powers);
      add(acceleration, stream.sums.acceleration);
      add(wall, stream.sums.impacts);
      add(impulses, stream.sums.impulses);
    }
  }
  double moment(int p, int q) const {
    if (p + q == 0) return 1;
    const auto at = std::ranges::find(mcs::kRecordedMomentPowers, std::pair{p, q}) -
                    mcs::kRecordedMomentPowers.begin();
    return powers[static_cast<std::size_t>(at)] / samples;
  }
};

void check_flights(const problem::System& system, const DepositedSumsOverTrajectories& sums,
                   SimulationIdentityChecks& checks) {
  const auto& of_system = system.coefficients();
  const auto defect = [&, c = of_system.damping, k = of_system.stiffness, mu = of_system.cubic](
                          int p, int q, double acceleration) {
    const double mean = acceleration / sums.samples + c * sums.moment(p, q + 1) +
                        k * sums.moment(p + 1, q) + mu * sums.moment(p + 3, q);
    return mean / (c * std::sqrt(sums.moment(0, 2) * sums.moment(2 * p, 2 * q)));
  };
  checks.momentum = defect(0, 0, sums.acceleration[0]);
  checks.virial = defect(1, 0, sums.acceleration[1]);
  checks.power = defect(0, 1, sums.acceleration[2]);
}

void check_impulses(const problem::ImpulseTrain& train, const DepositedSumsOverTrajectories& sums,
                    SimulationIdentityChecks& checks) {
  const auto& law = train.amplitude_law();
  const double expected = train.arrival_rate() * sums.time, n = sums.impulses[0];
  checks.rate = (n - expected) / std::sqrt(expected);
  if (n == 0) return;
  checks.mean =
      (sums.impulses[1] / n - law.mean()) / (law.amplitude_standard_deviation() / std::sqrt(n));
  // For impulses with the two amplitudes Y and -Y the square Y^2 has no variance. For impulses with
  // the amplitudes Y and -Y, a rounding error replaces the standard error of the mean of Y^2.
  const double square = law.moment(2), spread = law.moment(4) - square * square;
  const double scale = std::max(std::sqrt(std::max(spread, 0.0) / n), kRounding * square);
  checks.mean_square = (sums.impulses[2] / n - square) / scale;
}

Eigen::MatrixXd spline_coefficients_of_monomials(const DepositionSplineLayout& deposit_layout) {
  const Eigen::Index nv = deposit_layout.v.size();
  Eigen::MatrixXd all(deposit_layout.y.size() * nv,
                      static_cast<Eigen::Index>(mcs::kRecordedMomentPowers.size()));
  for (std::size_t n = 0; n < mcs::kRecordedMomentPowers.size(); ++n) {
    const auto in_y =
        deposit_layout.y.coefficients_of_monomial(mcs::kRecordedMomentPowers[n].first);
    const auto in_v =
        deposit_layout.v.coefficients_of_monomial(mcs::kRecordedMomentPowers[n].second);
    for (std::size_t i = 0; i < in_y.size(); ++i) {
      for (std::size_t j = 0; j < in_v.size(); ++j) {
        all(static_cast<Eigen::Index>(i) * nv + static_cast<Eigen::Index>(j),
            static_cast<Eigen::Index>(n)) = in_y[i] * in_v[j];
      }
    }
  }
  return all;
}

}  // namespace

HotellingTestResult hotelling_test(const Eigen::MatrixXd& all) {
  const Eigen::MatrixXd values = all.topRows(std::min(all.rows(), all.cols() / 2));
  const auto n = static_cast<double>(values.cols()), p = static_cast<double>(values.rows());
  const Eigen::VectorXd mean = values.rowwise().mean();
  Eigen::MatrixXd centred = values.colwise() - mean;
  const Eigen::VectorXd unit =
      (centred.rowwise().squaredNorm() / (n - 1)).cwiseSqrt().cwiseMax(1e-300).cwiseInverse();
  centred = (unit.asDiagonal() * centred).eval();
  const Eigen::VectorXd m = unit.cwiseProduct(mean);
  const Eigen::MatrixXd covariance = centred * centred.transpose() / (n - 1);
  const double statistic = n * m.dot(covariance.ldlt().solve(m));
  const double f = statistic * (n - p) / (p * (n - 1));
  const boost::math::fisher_f fisher(p, n - p);
  const double odds =
      std::isfinite(f) ? boost::math::cdf(boost::math::complement(fisher, std::max(f, 0.0))) : 0;
  return {.statistic = statistic, .dimensions = static_cast<int>(p), .p_value = odds};
}

SimulationIdentityChecks compute_simulation_identity_checks(
    const ControlVariateSetup& setup, const Eigen::MatrixXd& generator,
    std::span<const mcs::DepositedSumsOfTrajectory> streams,
    const StationaryFunctionalEstimates& estimates) {
  const DepositedSumsOverTrajectories sums(streams);
  SimulationIdentityChecks result;
  result.generator = hotelling_test(
      spline_coefficients_of_monomials(setup.deposit_layout).transpose() * generator);
  check_flights(setup.problem.system, sums, result);
  if (sums.impacts > 0) {
    result.restitution = sums.wall[1] / sums.wall[0] - setup.problem.system.restitution();
    result.wall_distance = sums.wall[2] / sums.impacts / std::sqrt(sums.moment(2, 0));
  }
  check_impulses(setup.problem.impulses, sums, result);
  for (const auto& [controlled, plain] : estimates.moments) {
    result.plain_moments = std::max(result.plain_moments,
                                    std::abs(plain.mean - controlled.mean) / plain.standard_error);
  }
  return result;
}

std::vector<std::string> SimulationIdentityChecks::failed_deterministic_check_names() const {
  std::vector<std::string> names;
  const auto add_if_failed = [&](bool fine, const char* name) {
    if (!fine) names.emplace_back(name);
  };
  add_if_failed(
      std::max({std::abs(momentum), std::abs(virial), std::abs(power)}) < kFlightTolerance,
      "flights");
  add_if_failed(std::abs(restitution) < kRounding, "restitution");
  add_if_failed(wall_distance < kRounding, "wall");
  return names;
}

std::vector<std::string> SimulationIdentityChecks::failed_check_names() const {
  std::vector<std::string> names = failed_deterministic_check_names();
  const auto add_if_failed = [&](bool fine, const char* name) {
    if (!fine) names.emplace_back(name);
  };
  add_if_failed(std::max({std::abs(rate), std::abs(mean), std::abs(mean_square)}) < kNormalQuantile,
                "impulses");
  add_if_failed(generator.p_value > kSignificanceLevel, "generator");
  add_if_failed(plain_moments < kNormalQuantile, "plain");
  return names;
}

}  // namespace fpkcheck::control_variates
