#include "backward/passage/mean_time_certificate.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "backward/passage/renewal_equation.hpp"
#include "base/process/parallel_for.hpp"

namespace fpkcheck::backward {

GrazingArc::GrazingArc(const ImpactOscillator& oscillator, int sign)
    : oscillator_(oscillator),
      sign_(sign),
      s_max_(std::sqrt(oscillator.barrier)),
      z_(kIntervals + 1),
      slopes_(kIntervals + 1) {}

double GrazingArc::slope(double s, double z) const {
  return 4 * s *
         (oscillator_.spring_force(oscillator_.barrier - s * s) +
          sign_ * oscillator_.damping * std::sqrt(std::max(z, 0.0)));
}

double GrazingArc::runge_kutta_step(double s, double z, double step) const {
  const double k1 = slope(s, z), k2 = slope(s + step / 2, z + step / 2 * k1);
  const double k3 = slope(s + step / 2, z + step / 2 * k2), k4 = slope(s + step, z + step * k3);
  return z + step / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
}

GrazingArc GrazingArc::outgoing(const ImpactOscillator& oscillator) {
  GrazingArc arc(oscillator, 1);
  const double step = arc.s_max_ / kIntervals;
  // z = 2 g(b) s^2 + (4/3) c sqrt(2 g(b)) s^3 + .. at the barrier. The first interval has steps of
  // increasing length.
  constexpr int kFirstSteps = 4000;
  constexpr double kFirstFraction = 1e-3;
  const double acceleration = oscillator.spring_force(oscillator.barrier);
  double s = kFirstFraction * step;
  double z =
      s * s * (2 * acceleration + 4.0 / 3 * oscillator.damping * std::sqrt(2 * acceleration) * s);
  const double ratio = std::pow(1 / kFirstFraction, 1.0 / kFirstSteps);
  for (int n = 0; n < kFirstSteps; ++n) {
    const double next = n + 1 == kFirstSteps ? step : s * ratio;
    z = arc.runge_kutta_step(s, z, next - s);
    s = next;
  }
  for (std::size_t i = 1; i <= kIntervals; ++i) {
    s = step * static_cast<double>(i);
    arc.z_[i] = z;
    arc.slopes_[i] = arc.slope(s, z);
    z = arc.runge_kutta_step(s, z, step);
  }
  return arc;
}

GrazingArc GrazingArc::incoming(const ImpactOscillator& oscillator, const GrazingArc& outgoing) {
  GrazingArc arc(oscillator, -1);
  const double step = arc.s_max_ / kIntervals;
  double z = outgoing.z_.back() / (oscillator.restitution * oscillator.restitution);
  for (std::size_t i = kIntervals + 1; i-- > 0;) {
    const double s = step * static_cast<double>(i);
    arc.z_[i] = z;
    arc.slopes_[i] = arc.slope(s, z);
    z = arc.runge_kutta_step(s, z, -step);
  }
  return arc;
}

double GrazingArc::speed(double s) const {
  const double step = s_max_ / kIntervals;
  const auto i =
      static_cast<std::size_t>(std::clamp(static_cast<int>(s / step), 0, kIntervals - 1));
  const double t = s / step - static_cast<double>(i);
  const double rise = z_[i + 1] - z_[i], m0 = slopes_[i] * step, m1 = slopes_[i + 1] * step;
  const double z = z_[i] + t * (m0 + t * (3 * rise - 2 * m0 - m1 + t * (m0 + m1 - 2 * rise)));
  return std::sqrt(std::max(z, 0.0));
}

double GrazingArc::smallest_speed() const {
  return std::sqrt(std::max(0.0, *std::ranges::min_element(z_)));
}
double GrazingArc::largest_speed() const { return std::sqrt(*std::ranges::max_element(z_)); }

double region_velocity(const ImpactOscillator& oscillator, const GrazingTrajectory& grazing,
                       Region region, double s, double eta) {
  const double speed = (is_incoming_region(region) ? grazing.incoming : grazing.outgoing).speed(s);
  if (is_trapped_region(region)) return (is_incoming_region(region) ? -eta : eta) * speed;
  return is_incoming_region(region) ? -std::hypot(eta / oscillator.restitution, speed)
                                    : std::hypot(eta, speed);
}

namespace {

// Slopes at the knots of the cubic spline that interpolates values: slopes = matrix * (values, left
// slope). Without a left slope the third derivative is continuous at the second knot. At the right
// end it is continuous at the last but one knot.
Eigen::MatrixXd spline_slope_matrix(const std::vector<double>& knots, bool has_left_slope) {
  const auto n = static_cast<Eigen::Index>(knots.size());
  Eigen::MatrixXd left = Eigen::MatrixXd::Zero(n, n), right = Eigen::MatrixXd::Zero(n, n + 1);
  const auto width = [&](Eigen::Index i) {
    return knots[static_cast<std::size_t>(i + 1)] - knots[static_cast<std::size_t>(i)];
  };
  for (Eigen::Index i = 1; i < n - 1; ++i) {
    const double h0 = width(i - 1), h1 = width(i);
    left.row(i).segment(i - 1, 3) << 1 / h0, 2 / h0 + 2 / h1, 1 / h1;
    right.row(i).segment(i - 1, 3) << -3 / (h0 * h0), 3 / (h0 * h0) - 3 / (h1 * h1), 3 / (h1 * h1);
  }
  // Continuity of the third derivative at the knot i + 1
  const auto join = [&](Eigen::Index row, Eigen::Index i) {
    const double h0 = width(i), h1 = width(i + 1);
    left.row(row).segment(i, 3) << 1 / (h0 * h0), 1 / (h0 * h0) - 1 / (h1 * h1), -1 / (h1 * h1);
    right.row(row).segment(i, 3) << -2 / (h0 * h0 * h0), 2 / (h0 * h0 * h0) + 2 / (h1 * h1 * h1),
        -2 / (h1 * h1 * h1);
  };
  if (has_left_slope) {
    left(0, 0) = right(0, n) = 1;
  } else {
    join(0, 0);
  }
  join(n - 1, n - 3);
  return left.partialPivLu().solve(right);
}

// Allowance e(y, v) of the certificates. The approximate mean times solve L V = -1 -+ e, so that
// the errors of the inequality L V <= -1, or >= -1, may be as large as e. The errors are largest
// near the grazing orbit (energy ratio 1) and near its end at the barrier, which the oscillator
// rarely visits. At large energies the allowance exceeds the contribution of the states outside the
// domain of V.
double certificate_allowance(const ImpactOscillator& oscillator, double y, double v) {
  constexpr double kEverywhere = 0.012, kAtGrazingEnergy = 0.025, kAtBarrier = 0.3,
                   kAtGrazingPoint = 1.5, kGrazingPointSize = 0.03;
  const double barrier_energy = oscillator.potential(oscillator.barrier);
  const double energy = (v * v / 2 + oscillator.potential(y)) / barrier_energy;
  const double energy_squared = energy * energy;
  const double height = y / oscillator.barrier;
  constexpr double kSize = kGrazingPointSize * kGrazingPointSize;
  const double distance = (1 - height) + v * v / (2 * barrier_energy);
  return kEverywhere + kAtGrazingEnergy * energy_squared * energy_squared +
         kAtBarrier * std::pow(height, 12) + kAtGrazingPoint * kSize / (kSize + distance);
}

struct CertificateSplineKnots {
  std::vector<double> s, s_of_exit_up, trapped_eta, exit_eta;
};

// Returns the knots of V. They are dense at the barrier (s = 0), at the wall, and at the grazing
// trajectory (eta = 1 in the trapped regions, eta = 0 in the exit regions).
CertificateSplineKnots certificate_knots(const ImpactOscillator& oscillator, double wall_speed,
                                         double largest_eta) {
  CertificateSplineKnots knots{
      .s = {0,   .004, .011, .017, .025, .035, .05, .07, .1, .14, .19, .24,  .3,   .36,
            .42, .48,  .54,  .6,   .66,  .72,  .78, .84, .9, .95, .98, .993, .998, 1},
      .s_of_exit_up = {0,  .002, .0032, .0048, .007, .011, .017, .025, .035, .05, .07, .1, .14,
                       .2, .27,  .35,   .43,   .51,  .59,  .67,  .75,  .82,  .89, .95, 1},
      .trapped_eta = {0,   .004, .012, .03, .07, .13,  .2,   .28,  .36,  .44,  .52,  .6,   .68,
                      .75, .81,  .86,  .9,  .93, .955, .973, .985, .992, .996, .998, .999, 1},
      .exit_eta = {0}};
  const double s_max = std::sqrt(oscillator.barrier);
  for (double& s : knots.s) s *= s_max;
  for (double& s : knots.s_of_exit_up) s *= s_max;
  knots.s.back() = knots.s_of_exit_up.back() = s_max;
  // In units of the speed of the grazing trajectory after the impact
  for (const double eta :
       {.00018, .0006, .0012, .0024, .0041, .007, .012, .018, .026, .038, .053, .076,
        .106,   .147,  .194,  .253,  .324,  .4,   .48,  .59,  .71,  .82,  .97,  1.15,
        1.35,   1.6,   1.9,   2.2,   2.6,   3.0,  3.5,  4.0,  4.5,  5.0}) {
    if (eta * wall_speed < 0.93 * largest_eta) knots.exit_eta.push_back(eta * wall_speed);
  }
  knots.exit_eta.push_back(largest_eta);
  return knots;
}

// Computes the slopes of V at the knots from the values. V_s(0, eta) is zero in the incoming
// regions, where V is smooth in s^2, and proportional to eta in the region trapped_up.
void compute_slopes(Region region, PiecewiseBicubicFunction& function) {
  const Eigen::Index n_s = function.value.rows(), n_eta = function.value.cols();
  Eigen::MatrixXd values(n_s + 1, n_eta);
  values.topRows(n_s) = function.value;
  values.row(n_s).setZero();
  if (region == trapped_up) {
    const double slope =
        (function.value(1, n_eta - 1) - function.value(0, 0)) / function.s_knots[1];
    for (Eigen::Index j = 0; j < n_eta; ++j)
      values(n_s, j) = slope * function.eta_knots[static_cast<std::size_t>(j)];
  }
  if (region == exit_up) {
    // The inequality is not needed in the first interval, where V is not smooth.
    const std::vector<double> later(function.s_knots.begin() + 1, function.s_knots.end());
    function.s_slope.resize(n_s, n_eta);
    const Eigen::MatrixXd slopes = spline_slope_matrix(later, false);
    function.s_slope.bottomRows(n_s - 1) =
        slopes.leftCols(n_s - 1) * function.value.bottomRows(n_s - 1);
    const double s1 = function.s_knots[1], s2 = function.s_knots[2];
    function.s_slope.row(0) =
        (s2 * s2 * function.value.row(1) - s1 * s1 * function.value.row(2)) / (s1 * s2 * (s2 - s1));
  } else {
    function.s_slope = spline_slope_matrix(function.s_knots, true) * values;
  }
  const Eigen::MatrixXd eta_matrix = spline_slope_matrix(function.eta_knots, false).leftCols(n_eta);
  function.eta_slope = function.value * eta_matrix.transpose();
  function.mixed_slope = function.s_slope * eta_matrix.transpose();
  // Exact zeros, which rounding may have changed
  if (is_incoming_region(region)) {
    function.s_slope.row(0).setZero();
    function.mixed_slope.row(0).setZero();
  } else {
    function.eta_slope.row(0).setZero();
  }
}

}  // namespace

std::optional<std::array<MeanPassageTimeCertificate, 2>> compute_mean_time_certificates(
    const problem::Problem& problem, const ImpactOscillator& oscillator,
    const base::Deadline& deadline) {
  const GrazingTrajectory grazing(oscillator);
  const double rate = oscillator.arrival_rate, barrier = oscillator.barrier;
  const double s_max = std::sqrt(barrier), wall_speed = grazing.outgoing.speed(s_max);
  // Outside the domain, eta > largest_eta, the speed exceeds twice the barrier times the rate. The
  // proof needs this inequality.
  const double largest_eta = std::max(2 * rate * barrier + 0.7 * wall_speed, 2.47 * wall_speed);
  const CertificateSplineKnots knots = certificate_knots(oscillator, wall_speed, largest_eta);

  // Collocation of the renewal equation with the sources 1 + e and 1 - e
  constexpr double kNodesPerDeviation = 2.1, kPanelRefinement = 0.3;
  const double v_max = 1.07 * largest_eta;
  const double n_y = std::ceil(kNodesPerDeviation * (4 + std::sqrt(oscillator.stiffness) * barrier /
                                                             oscillator.deviation)),
               n_v = std::ceil(kNodesPerDeviation * 2 * v_max / oscillator.deviation);
  constexpr double kMaxNodes = 5000;  // the dense matrices then take about 1 GB
  if (!(n_y * n_v <= kMaxNodes)) return std::nullopt;
  const ChebyshevGrid grid({0, barrier, v_max}, static_cast<int>(n_y), static_cast<int>(n_v));
  const RenewalEquation equation(problem, grid, rate, kPanelRefinement);
  auto operators = equation.compute_operators({{rate}}, deadline);
  if (operators.empty()) return std::nullopt;
  Eigen::VectorXd allowances(grid.node_count());
  for (int i = 0; i < grid.y_node_count(); ++i) {
    for (int j = 0; j < grid.v_node_count(); ++j)
      allowances(grid.node_index(i, j)) =
          certificate_allowance(oscillator, grid.y_node(i), grid.v_node(j));
  }
  Eigen::MatrixXd sources(grid.node_count(), 2);
  const Eigen::VectorXd of_allowance = operators[0].matrix * allowances;
  sources << operators[0].values_of_one + of_allowance, operators[0].values_of_one - of_allowance;
  Eigen::MatrixXd matrix = -rate * operators[0].matrix;
  matrix.diagonal().array() += 1;
  const Eigen::MatrixXd solutions = matrix.partialPivLu().solve(sources);
  std::array<Eigen::MatrixXd, 2> h;  // shape (v nodes, y nodes)
  for (Eigen::Index k = 0; k < 2; ++k)
    h[static_cast<std::size_t>(k)] =
        solutions.col(k).reshaped(grid.v_node_count(), grid.y_node_count());

  // Mean times of both certificates from one state. Motions from the trapped regions do not pass a
  // barrier that is slightly higher.
  constexpr double kHigher = 1e-7, kMaxExponent = 16;
  const UnforcedMotionSolver motion(problem.system, barrier, barrier, oscillator.deviation, 1);
  const UnforcedMotionSolver trapped_motion(problem.system, barrier + kHigher, barrier,
                                            oscillator.deviation, 1);
  const auto mean_times_from = [&](const PhaseState& start, bool trapped) {
    const UnforcedTrajectory trajectory =
        (trapped ? trapped_motion : motion).compute_trajectory(start, kMaxExponent / rate);
    Eigen::VectorXd y_polynomials(grid.y_node_count()), v_polynomials(grid.v_node_count());
    std::array<double, 2> times{};
    const auto add = [&](double weight, const PhaseState& state) {
      grid.evaluate_y_polynomials(state.y, y_polynomials);
      grid.evaluate_v_polynomials(state.v, v_polynomials);
      const double allowance = certificate_allowance(oscillator, state.y, state.v);
      for (std::size_t k = 0; k < 2; ++k)
        times[k] += weight * (1 + (k == 0 ? allowance : -allowance) +
                              rate * v_polynomials.dot(h[k] * y_polynomials));
    };
    for (const TrajectoryQuadratureNode& node : trajectory.nodes)
      add(node.weight * std::exp(-rate * node.time), node.state);
    if (!trajectory.passed_barrier)
      add(std::exp(-rate * trajectory.duration) / rate, trajectory.end_state);
    return times;
  };

  std::array<MeanPassageTimeCertificate, 2> certificates{
      MeanPassageTimeCertificate{.is_upper = true, .regions = {}},
      MeanPassageTimeCertificate{.is_upper = false, .regions = {}}};
  for (const Region region : kRegions) {
    const auto& s_knots = region == exit_up ? knots.s_of_exit_up : knots.s;
    const auto& eta_knots = is_trapped_region(region) ? knots.trapped_eta : knots.exit_eta;
    const auto n_s = static_cast<Eigen::Index>(s_knots.size());
    const auto n_eta = static_cast<Eigen::Index>(eta_knots.size());
    for (MeanPassageTimeCertificate& certificate : certificates)
      certificate.regions[region] = {s_knots, eta_knots, Eigen::MatrixXd::Zero(n_s, n_eta),
                                     {},      {},        {}};
    base::parallel_for(s_knots.size(), base::kOneThreadPerProcessor, [&](std::size_t row) {
      for (std::size_t column = 0; column < eta_knots.size(); ++column) {
        if (region == exit_up && row == 0) continue;
        if (deadline.has_deadline_passed()) return;
        constexpr double kInside = 1e-12, kOutside = 1e-6;
        const double s = s_knots[row];
        const double eta = is_trapped_region(region) ? std::min(eta_knots[column], 1 - kInside)
                                                     : std::max(eta_knots[column], kOutside);
        const bool is_at_wall = row + 1 == s_knots.size();
        // At the wall V has the values after the impact.
        const Region after = !is_at_wall              ? region
                             : region == trapped_down ? trapped_up
                             : region == exit_down    ? exit_up
                                                      : region;
        const auto times = mean_times_from(
            {is_at_wall ? 0 : barrier - s * s, region_velocity(oscillator, grazing, after, s, eta)},
            is_trapped_region(region));
        for (std::size_t k = 0; k < 2; ++k)
          certificates[k].regions[region].value(static_cast<Eigen::Index>(row),
                                                static_cast<Eigen::Index>(column)) = times[k];
      }
    });
  }
  if (deadline.has_deadline_passed()) return std::nullopt;
  for (MeanPassageTimeCertificate& certificate : certificates) {
    auto& [down, up, exit_down_function, exit_up_function] = certificate.regions;
    // Equal values where regions meet: at v = 0, and before and after an impact. At the barrier all
    // values of eta in the region trapped_up are the same state.
    up.value.col(0) = down.value.col(0);
    up.value.bottomRows(1) = down.value.bottomRows(1);
    up.value.row(0).setConstant(down.value(0, 0));
    exit_up_function.value.bottomRows(1) = exit_down_function.value.bottomRows(1);
    for (const Region region : kRegions) compute_slopes(region, certificate.regions[region]);
    up.s_slope.col(0) = down.s_slope.col(0);
    up.eta_slope.bottomRows(1) = down.eta_slope.bottomRows(1);
    exit_up_function.eta_slope.bottomRows(1) = exit_down_function.eta_slope.bottomRows(1);
  }
  return certificates;
}

}  // namespace fpkcheck::backward
