#include "fd_fpk/functionals/energy_level_grid.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "numerics/chebyshev_interpolation.hpp"
#include "numerics/quadrature/gauss_rule.hpp"

namespace fpkcheck::fd_fpk {
namespace {

constexpr double kPi = std::numbers::pi;

// Numbers of nodes of an upwind-biased stencil on the upstream side, from which values come, and on
// the other side
constexpr int kUpstream = 3, kDownstream = 2;
// The same in the columns next to a turning point, and the number of these columns. There the rate
// of change of eta is inversely proportional to the distance in s, and with the longer stencils the
// matrix has growing modes at the turning point.
constexpr int kUpstreamAtTurningPoint = 2, kDownstreamAtTurningPoint = 1;
constexpr int kColumnsAtTurningPoint = 2;
constexpr int kInterpolationNodes = 6;

}  // namespace

EnergyLevelGrid::EnergyLevelGrid(const problem::System& system,
                                 const problem::EffectivePotential& potential,
                                 const problem::HalfCycle& interval, double level,
                                 int displacement_count, int velocity_count,
                                 const BackwardEquationExcitation& excitation)
    : system_(system),
      potential_(potential),
      interval_(interval),
      level_(level),
      n_s_(displacement_count),
      excitation_(excitation) {
  assert(velocity_count % 2 == 0);
  assert(std::min(displacement_count, velocity_count) >= kInterpolationNodes);
  for (int j = 0; j < velocity_count; ++j) {
    eta_.push_back(-std::cos(kPi * (j + 0.5) / velocity_count));
  }
  for (int i = 0; i < n_s_; ++i) {
    y_.push_back(displacement_at(column_position(i)));
    w_.push_back(speed_on_level(y_[i]));
    // Relative rounding error of the static force, which damping_force() subtracts
    constexpr double kRounding = 1e-12;
    const double rounding = kRounding * std::abs(system.force(y_[i], 0));
    const bool diffuses = excitation.diffusion > 0;
    vanishes_.push_back({diffuses || system.damping_force(y_[i], -w_[i]) > rounding,
                         diffuses || system.damping_force(y_[i], w_[i]) < -rounding});
  }
}

double EnergyLevelGrid::speed_on_level(double y) const {
  if (y < interval_.left || y > interval_.right) return 0;
  return std::sqrt(std::max(0.0, 2 * (level_ - potential_(y))));
}

double EnergyLevelGrid::displacement_at(double s) const {
  const auto& [left, right, left_is_wall, right_is_wall] = interval_;
  const double length = right - left;
  if (left_is_wall && right_is_wall) return left + length * s;
  if (left_is_wall) return left + length * std::sin(kPi * s / 2);
  if (right_is_wall) return right - length * std::cos(kPi * s / 2);
  return (left + right) / 2 - length / 2 * std::cos(kPi * s);
}

double EnergyLevelGrid::displacement_slope(double s) const {
  const auto& [left, right, left_is_wall, right_is_wall] = interval_;
  const double length = right - left;
  if (left_is_wall && right_is_wall) return length;
  if (left_is_wall) return length * kPi / 2 * std::cos(kPi * s / 2);
  if (right_is_wall) return length * kPi / 2 * std::sin(kPi * s / 2);
  return length * kPi / 2 * std::sin(kPi * s);
}

double EnergyLevelGrid::phase_of(double y) const {
  const auto& [left, right, left_is_wall, right_is_wall] = interval_;
  const double part = std::clamp((y - left) / (right - left), 0.0, 1.0);
  if (left_is_wall && right_is_wall) return part;
  if (left_is_wall) return std::asin(part) * 2 / kPi;
  if (right_is_wall) return std::acos(1 - part) * 2 / kPi;
  return std::acos(1 - 2 * part) / kPi;
}

double EnergyLevelGrid::column_position(int k) const {
  if (k < 0 && interval_.left_is_wall) return 0;
  if (k >= n_s_ && interval_.right_is_wall) return 1;
  return (k + 0.5) / n_s_;
}

int EnergyLevelGrid::first_column(bool with_wall) const {
  if (interval_.left_is_wall) return with_wall ? -1 : 0;
  return -kUpstream;
}

int EnergyLevelGrid::last_column(bool with_wall) const {
  if (interval_.right_is_wall) return with_wall ? n_s_ : n_s_ - 1;
  return n_s_ - 1 + kUpstream;
}

// Adds the value at an eta in column i, from nodes with the indices `first` .. `last`. The indices
// -1 and velocity_count() denote the ends eta = -1 and 1.
void EnergyLevelGrid::add_value_in_column(int i, double eta, double weight, int first, int last,
                                          Entries& entries) const {
  const auto above = static_cast<int>(std::ranges::upper_bound(eta_, eta) - eta_.begin());
  const int low = std::max(first, above - kInterpolationNodes / 2);
  const int high = std::min(last, above + kInterpolationNodes / 2 - 1);
  std::vector<double> positions;
  for (int j = low; j <= high; ++j) {
    positions.push_back(j < 0 ? -1 : j >= velocity_count() ? 1 : eta_[j]);
  }
  const std::vector<double> weights = numerics::lagrange_weights(positions, eta);
  for (int j = low; j <= high; ++j) {
    if (j >= 0 && j < velocity_count()) {
      entries.emplace_back(grid_node_index(i, j), weight * weights[j - low]);
    }
  }
}

// Adds the value at a wall. The value before an impact is that after the impact.
void EnergyLevelGrid::add_value_at_wall(bool left, double eta, double weight,
                                        Entries& entries) const {
  const bool impacts = left ? eta < 0 : eta > 0;
  if (impacts) {
    const problem::Wall& wall = left ? *system_.left_wall() : *system_.right_wall();
    const double speed = std::abs(eta) * speed_on_level(wall.position);
    eta *= -wall.restitution_at_speed(speed);
  }
  // The slope of T in v jumps at v = 0 on the wall, so that the nodes have one sign of v.
  const int half = velocity_count() / 2;
  const int first = left ? half : vanishes_.back()[0] ? -1 : 0;
  const int last = left ? velocity_count() - 1 + (vanishes_.front()[1] ? 1 : 0) : half - 1;
  std::vector<double> positions;
  const int begin = left ? 0 : n_s_ - kInterpolationNodes;
  for (int k = begin; k < begin + kInterpolationNodes; ++k) {
    positions.push_back(column_position(k));
  }
  const std::vector<double> weights = numerics::lagrange_weights(positions, left ? 0 : 1);
  for (int k = 0; k < kInterpolationNodes; ++k) {
    add_value_in_column(begin + k, eta, weight * weights[k], first, last, entries);
  }
}

// Adds the value of node j in a column, which may be a wall or a reflected column.
void EnergyLevelGrid::add_node_value(int column, int j, double weight, Entries& entries) const {
  const bool left = column < 0;
  if (!left && column < n_s_) {
    entries.emplace_back(grid_node_index(column, j), weight);
  } else if (left ? interval_.left_is_wall : interval_.right_is_wall) {
    add_value_at_wall(left, eta_[j], weight, entries);
  } else {
    const int reflected = left ? -1 - column : 2 * n_s_ - 1 - column;
    entries.emplace_back(grid_node_index(reflected, velocity_count() - 1 - j), weight);
  }
}

// Adds the value at an eta in a column inside or in a reflected column.
void EnergyLevelGrid::add_interpolated_value(int column, double eta, double weight,
                                             Entries& entries) const {
  if (column < 0 || column >= n_s_) {
    column = column < 0 ? -1 - column : 2 * n_s_ - 1 - column;
    eta = -eta;
  }
  add_value_in_column(column, eta, weight, vanishes_[column][0] ? -1 : 0,
                      velocity_count() - 1 + (vanishes_[column][1] ? 1 : 0), entries);
}

void EnergyLevelGrid::add_value_at_phase(double s, double eta, double weight,
                                         Entries& entries) const {
  const int first = first_column(false), last = last_column(false);
  const int begin =
      std::clamp(static_cast<int>(std::floor(s * n_s_ + 0.5)) - kInterpolationNodes / 2, first,
                 last + 1 - kInterpolationNodes);
  std::vector<double> positions;
  for (int k = begin; k < begin + kInterpolationNodes; ++k) {
    positions.push_back(column_position(k));
  }
  const std::vector<double> weights = numerics::lagrange_weights(positions, s);
  for (int k = 0; k < kInterpolationNodes; ++k) {
    add_interpolated_value(begin + k, eta, weight * weights[k], entries);
  }
}

// Adds a derivative with respect to eta at node (i, j), from the nodes `first` .. `last` as far as
// they exist.
void EnergyLevelGrid::add_eta_derivative(int i, int j, int order, double weight, int first,
                                         int last, Entries& entries) const {
  const int low = std::max(first, vanishes_[i][0] ? -1 : 0);
  const int high = std::min(last, velocity_count() - 1 + (vanishes_[i][1] ? 1 : 0));
  std::vector<double> positions;
  for (int k = low; k <= high; ++k) {
    positions.push_back(k < 0 ? -1 : k >= velocity_count() ? 1 : eta_[k]);
  }
  const auto weights = numerics::lagrange_derivative_weights(positions, eta_[j], order);
  for (int k = low; k <= high; ++k) {
    if (k >= 0 && k < velocity_count()) {
      entries.emplace_back(grid_node_index(i, k), weight * weights[k - low]);
    }
  }
}

// Adds lambda (E[T(y, v + Y)] - T), where impulses to the level or above contribute 0.
void EnergyLevelGrid::add_impulses(int i, int j, Entries& entries) const {
  const double rate = excitation_.impulse_rate, v = velocity(i, j);
  excitation_.for_each_amplitude(-w_[i] - v, w_[i] - v, [&](double amplitude, double weight) {
    add_interpolated_value(i, (v + amplitude) / w_[i], rate * weight, entries);
  });
  entries.emplace_back(grid_node_index(i, j), -rate);
}

SparseColumnMatrix EnergyLevelGrid::backward_matrix() const {
  std::vector<Eigen::Triplet<double>> triplets;
  Entries entries;
  for (int i = 0; i < n_s_; ++i) {
    const double s = column_position(i), slope = displacement_slope(s);
    const double static_force = system_.force(y_[i], 0);
    const bool turns = (!interval_.left_is_wall && i < kColumnsAtTurningPoint) ||
                       (!interval_.right_is_wall && i >= n_s_ - kColumnsAtTurningPoint);
    const int upstream = turns ? kUpstreamAtTurningPoint : kUpstream;
    const int downstream = turns ? kDownstreamAtTurningPoint : kDownstream;
    for (int j = 0; j < velocity_count(); ++j) {
      entries.clear();
      const double eta = eta_[j], v = velocity(i, j);
      const bool right = v > 0;  // the direction of the motion, from which the values come
      const int first = std::max(i - (right ? downstream : upstream), first_column(!right));
      const int last = std::min(i + (right ? upstream : downstream), last_column(right));
      std::vector<double> positions;
      for (int k = first; k <= last; ++k) positions.push_back(column_position(k));
      const auto weights = numerics::lagrange_derivative_weights(positions, s, 1);
      for (int k = first; k <= last; ++k) {
        add_node_value(k, j, v / slope * weights[k - first], entries);
      }
      const double rate =
          (eta * eta * static_force - system_.force(y_[i], v) + excitation_.drift) / w_[i];
      const bool up = rate > 0;
      add_eta_derivative(i, j, 1, rate, j - (up ? downstream : upstream),
                         j + (up ? upstream : downstream), entries);
      if (excitation_.diffusion > 0) {
        add_eta_derivative(i, j, 2, excitation_.diffusion / (w_[i] * w_[i]), j - kUpstream,
                           j + kUpstream, entries);
      }
      if (excitation_.impulse_rate > 0) add_impulses(i, j, entries);
      for (const auto& [node, weight] : entries)
        triplets.emplace_back(grid_node_index(i, j), node, weight);
    }
  }
  SparseColumnMatrix matrix(size(), size());
  matrix.setFromTriplets(triplets.begin(), triplets.end());
  return matrix;
}

Eigen::VectorXd EnergyLevelGrid::integration_weights() const {
  // The integrand y'(s) w T is even about a turning point, as T is.
  Eigen::VectorXd of_s = Eigen::VectorXd::Zero(n_s_);
  for (const auto& [s, weight] : numerics::composite_gauss_points<4>(0, 1, n_s_)) {
    const int begin =
        std::clamp(static_cast<int>(std::floor(s * n_s_ + 0.5)) - kInterpolationNodes / 2,
                   first_column(false), last_column(false) + 1 - kInterpolationNodes);
    std::vector<double> positions;
    for (int k = 0; k < kInterpolationNodes; ++k) positions.push_back(column_position(begin + k));
    const auto weights = numerics::lagrange_weights(positions, s);
    for (int k = 0; k < kInterpolationNodes; ++k) {
      const int column = begin + k;
      const int inside = column < 0 ? -1 - column : column >= n_s_ ? 2 * n_s_ - 1 - column : column;
      of_s(inside) += weight * weights[k];
    }
  }
  // Fejer's first rule at the Chebyshev points
  const int n = velocity_count();
  Eigen::VectorXd of_eta(n);
  for (int j = 0; j < n; ++j) {
    double sum = 1;
    for (int k = 1; k <= n / 2; ++k) {
      sum -= 2 * std::cos(2 * k * kPi * (j + 0.5) / n) / (4.0 * k * k - 1);
    }
    of_eta(j) = 2 * sum / n;
  }
  Eigen::VectorXd weights(size());
  for (int i = 0; i < n_s_; ++i) {
    weights.segment(grid_node_index(i, 0), n) =
        of_s(i) * displacement_slope(column_position(i)) * w_[i] * of_eta;
  }
  return weights;
}

Eigen::VectorXd EnergyLevelGrid::interpolation_weights_at_state(double y, double v) const {
  assert(std::abs(v) < speed_on_level(y));
  Entries entries;
  const double eta = v / speed_on_level(y);
  if (interval_.left_is_wall && y <= interval_.left) {
    add_value_at_wall(true, eta, 1, entries);
  } else if (interval_.right_is_wall && y >= interval_.right) {
    add_value_at_wall(false, eta, 1, entries);
  } else {
    add_value_at_phase(phase_of(y), eta, 1, entries);
  }
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(size());
  for (const auto& [node, weight] : entries) weights(node) += weight;
  return weights;
}

Eigen::VectorXd EnergyLevelGrid::mean_after_impulse_weights(double y) const {
  const double speed = speed_on_level(y);
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(size());
  const auto add = [&](double v, double weight) {
    weights += weight * interpolation_weights_at_state(y, v);
  };
  // On a wall the slope of the mean time jumps at v = 0.
  excitation_.for_each_amplitude(-speed, 0, add);
  excitation_.for_each_amplitude(0, speed, add);
  return weights;
}

}  // namespace fpkcheck::fd_fpk
