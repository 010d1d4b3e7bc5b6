#include "fd_fpk/functionals/barrier_grid.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "numerics/chebyshev_interpolation.hpp"
#include "numerics/roots/bracketed_root.hpp"

namespace fpkcheck::fd_fpk {
namespace {

// Numbers of nodes of an upwind-biased stencil on the upstream side, from which values come, and on
// the other side
constexpr int kUpstreamNodes = 3, kDownstreamNodes = 2;
// Number of nodes on each side in the second derivative
constexpr int kDiffusionNodes = 2;
constexpr int kInterpolated = 6;  // number of nodes of an interpolation
// Parameter a of v = V sinh(a eta) / sinh(a). The widths of the cells at v = 0 and at v = V differ
// by the factor cosh(a) = 10. With a = 3 and distances d ~ s^4 from the ends, 44 x 66 nodes compute
// the mean time from (0, 0) with relative errors of at most 2e-4 for x'' = xi in (0, 1) with a wall
// at 0 (r = 1, 0.5, 0.25), and 3e-5 for case 1 under white noise. With a = 4 or d ~ s^5 the error
// in case 1 is larger; with d ~ s^3 the errors for r < 1 are larger.
constexpr double kVelocityGrading = 3;

// The polynomial of degree 7 from 0 at s = 0 to 1 at s = 1 with derivatives 1 to 3 equal to 0 at
// both ends, and the derivative of the polynomial
double graded_part(double s) { return s * s * s * s * (35 + s * (-84 + s * (70 - 20 * s))); }
double graded_part_slope(double s) { return 140 * std::pow(s * (1 - s), 3); }

// Returns the weights of equidistant nodes, at the given distances in steps, in a derivative.
std::vector<double> equidistant_derivative_weights(int first, int last, int order) {
  std::vector<double> positions;
  for (int k = first; k <= last; ++k) positions.push_back(k);
  return numerics::lagrange_derivative_weights(positions, 0, order);
}

}  // namespace

BarrierGrid::BarrierGrid(const problem::Problem& problem,
                         const BackwardEquationExcitation& excitation, const PassageStrip& strip,
                         int displacement_count, int velocity_count)
    : problem_(problem),
      excitation_(excitation),
      strip_(strip),
      n_s_(displacement_count),
      n_eta_(velocity_count) {
  assert(velocity_count % 2 == 0);
  assert(displacement_count >= kInterpolated && velocity_count >= 2 * kInterpolated);
  assert(strip.lower < strip.upper);
}

double BarrierGrid::displacement_at(double s) const {
  if (strip_.lower_end == PassageStrip::LowerEnd::box) {  // no singularity at the lower end
    return strip_.upper - (strip_.upper - strip_.lower) * 2 * graded_part((1 - s) / 2);
  }
  return std::lerp(strip_.lower, strip_.upper, graded_part(s));
}

double BarrierGrid::displacement_slope(double s) const {
  return (strip_.upper - strip_.lower) * (strip_.lower_end == PassageStrip::LowerEnd::box
                                              ? graded_part_slope((1 - s) / 2)
                                              : graded_part_slope(s));
}

double BarrierGrid::velocity_at(double eta) const {
  return strip_.largest_speed * std::sinh(kVelocityGrading * eta) / std::sinh(kVelocityGrading);
}

double BarrierGrid::velocity_slope(double eta) const {
  return strip_.largest_speed * kVelocityGrading * std::cosh(kVelocityGrading * eta) /
         std::sinh(kVelocityGrading);
}

double BarrierGrid::velocity_curvature(double eta) const {
  return kVelocityGrading * kVelocityGrading * velocity_at(eta);
}

double BarrierGrid::eta_of(double v) const {
  const double part = std::clamp(v / strip_.largest_speed, -1.0, 1.0);
  return std::asinh(part * std::sinh(kVelocityGrading)) / kVelocityGrading;
}

double BarrierGrid::column_position(int k) const { return std::clamp((k + 0.5) / n_s_, 0.0, 1.0); }

int BarrierGrid::reflected_velocity_node(int j) const {
  if (j < 0) return -1 - j;
  return j >= n_eta_ ? 2 * n_eta_ - 1 - j : j;
}

// Adds the value at an eta in column i. The nodes -1, -2, .. and velocity_count(), .. are
// reflections about eta = -1 and eta = 1.
void BarrierGrid::add_value_in_column(int i, double eta, double weight, int first, int last,
                                      Entries& entries) const {
  const double position = (eta + 1) / eta_step() - 0.5;  // in steps from node 0
  const int begin = std::clamp(static_cast<int>(std::floor(position)) + 1 - kInterpolated / 2,
                               first, last + 1 - kInterpolated);
  std::vector<double> positions;
  for (int k = begin; k < begin + kInterpolated; ++k) positions.push_back(k);
  const std::vector<double> weights = numerics::lagrange_weights(positions, position);
  for (int k = 0; k < kInterpolated; ++k) {
    entries.emplace_back(grid_node_index(i, reflected_velocity_node(begin + k)),
                         weight * weights[k]);
  }
}

// Adds the value at the lower end. At a wall and at the end of the box the value before an impact
// is that after the impact.
void BarrierGrid::add_value_at_lower_end(double v, double weight, Entries& entries) const {
  if (v < 0) {
    v = strip_.lower_end == PassageStrip::LowerEnd::wall
            ? -v * problem_.system.left_wall()->restitution_at_speed(-v)
            : -v;
  }
  std::vector<double> positions;
  for (int k = 0; k < kInterpolated; ++k) positions.push_back(column_position(k));
  const std::vector<double> weights = numerics::lagrange_weights(positions, 0);
  // The slope of T in v jumps at v = 0 on the wall, so that all nodes have v > 0.
  for (int k = 0; k < kInterpolated; ++k) {
    add_value_in_column(k, eta_of(v), weight * weights[k], n_eta_ / 2, n_eta_ + kInterpolated,
                        entries);
  }
}

double BarrierGrid::add_displacement_terms(int i, int j, Entries& entries) const {
  const double v = velocity(j), s = column_position(i), rate = v / displacement_slope(s);
  const bool up = v > 0;  // the direction of the motion, from which the values come
  // Values at an end are known only where the motion leaves the strip.
  const int first = std::max(i - (up ? kDownstreamNodes : kUpstreamNodes), up ? 0 : -1);
  const int last = std::min(i + (up ? kUpstreamNodes : kDownstreamNodes), up ? n_s_ : n_s_ - 1);
  std::vector<double> positions;
  for (int k = first; k <= last; ++k) positions.push_back(column_position(k));
  const std::vector<double> weights = numerics::lagrange_derivative_weights(positions, s, 1);
  double of_upper_end = 0;
  for (int k = first; k <= last; ++k) {
    const double weight = rate * weights[k - first];
    if (k == n_s_) {
      of_upper_end = weight;
    } else if (k >= 0) {
      entries.emplace_back(grid_node_index(k, j), weight);
    } else if (strip_.lower_end != PassageStrip::LowerEnd::barrier) {
      add_value_at_lower_end(v, weight, entries);
    }
  }
  return of_upper_end;
}

void BarrierGrid::add_velocity_terms(int i, int j, Entries& entries) const {
  const double y = displacement(i), v = velocity(j), slope = velocity_slope(eta(j));
  double diffusion = excitation_.diffusion;
  if (problem_.noise_factor) {
    diffusion += problem::noise_diffusion_coefficient(problem_, y, v) - problem_.noise.diffusion();
  }
  const auto add = [&](int first, int last, int order, double rate) {
    const std::vector<double> weights = equidistant_derivative_weights(first, last, order);
    for (int k = first; k <= last; ++k) {
      entries.emplace_back(grid_node_index(i, reflected_velocity_node(j + k)),
                           rate * weights[k - first] / std::pow(eta_step(), order));
    }
  };
  // T_vv = (T_ee - v'' T_e / v') / v'^2 with e = eta
  const double rate = (excitation_.drift - problem_.system.force(y, v)) / slope -
                      diffusion * velocity_curvature(eta(j)) / (slope * slope * slope);
  const bool up = rate > 0;
  add(-(up ? kDownstreamNodes : kUpstreamNodes), up ? kUpstreamNodes : kDownstreamNodes, 1, rate);
  if (diffusion > 0) add(-kDiffusionNodes, kDiffusionNodes, 2, diffusion / (slope * slope));
}

std::vector<double> BarrierGrid::displacement_edges() const {
  std::vector<double> edges;
  for (int i = 0; i <= n_s_; ++i) edges.push_back(displacement_at(1.0 * i / n_s_));
  return edges;
}

std::vector<double> BarrierGrid::velocity_edges() const {
  std::vector<double> edges;
  for (int j = 0; j <= n_eta_; ++j) edges.push_back(velocity_at(j * eta_step() - 1));
  return edges;
}

// Returns the matrix of the impulses in a column, shape (velocity_count, velocity_count). Impulses
// beyond the largest speed are omitted, so that the impulses conserve probability.
Eigen::MatrixXd BarrierGrid::impulse_matrix() const {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n_eta_, n_eta_);
  if (excitation_.impulse_rate == 0) return matrix;
  for (int j = 0; j < n_eta_; ++j) {
    const double v = velocity(j);
    Entries entries;
    excitation_.for_each_amplitude(
        -strip_.largest_speed - v, strip_.largest_speed - v, [&](double amplitude, double weight) {
          add_value_in_column(0, eta_of(v + amplitude), weight, -kInterpolated,
                              n_eta_ + kInterpolated, entries);
          entries.emplace_back(j, -weight);
        });
    for (const auto& [node, weight] : entries) matrix(j, node) += weight;
  }
  return excitation_.impulse_rate * matrix;
}

BarrierGrid::BackwardSystem BarrierGrid::backward_system() const {
  BackwardSystem system{SparseColumnMatrix(size(), size()), Eigen::VectorXd::Zero(size())};
  const Eigen::MatrixXd of_impulses = impulse_matrix();
  std::vector<Eigen::Triplet<double>> triplets;
  Entries entries;
  for (int i = 0; i < n_s_; ++i) {
    for (int j = 0; j < n_eta_; ++j) {
      const int row = grid_node_index(i, j);
      entries.clear();
      system.upper_exit_terms(row) = add_displacement_terms(i, j, entries);
      add_velocity_terms(i, j, entries);
      for (const auto& [node, weight] : entries) triplets.emplace_back(row, node, weight);
      for (int k = 0; k < n_eta_; ++k) {
        if (of_impulses(j, k) != 0)
          triplets.emplace_back(row, grid_node_index(i, k), of_impulses(j, k));
      }
    }
  }
  system.matrix.setFromTriplets(triplets.begin(), triplets.end());
  return system;
}

Eigen::VectorXd BarrierGrid::integration_weights() const {
  Eigen::VectorXd weights(size());
  for (int i = 0; i < n_s_; ++i) {
    const double of_y = displacement_slope(column_position(i)) / n_s_;
    for (int j = 0; j < n_eta_; ++j) weights(grid_node_index(i, j)) = of_y * velocity_weight(j);
  }
  return weights;
}

Eigen::VectorXd BarrierGrid::interpolation_weights_at_state(double y, double v) const {
  Entries entries;
  if (y <= strip_.lower) {
    assert(strip_.lower_end != PassageStrip::LowerEnd::barrier || v > 0);
    add_value_at_lower_end(v, 1, entries);
  } else {
    const double s =
        numerics::bracketed_root([&](double at) { return displacement_at(at) - y; }, 0, 1);
    const int begin = std::clamp(static_cast<int>(std::floor(s * n_s_ + 0.5)) - kInterpolated / 2,
                                 0, n_s_ - kInterpolated);
    std::vector<double> positions;
    for (int k = begin; k < begin + kInterpolated; ++k) positions.push_back(column_position(k));
    const std::vector<double> weights = numerics::lagrange_weights(positions, s);
    for (int k = 0; k < kInterpolated; ++k) {
      add_value_in_column(begin + k, eta_of(v), weights[k], -kInterpolated, n_eta_ + kInterpolated,
                          entries);
    }
  }
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(size());
  for (const auto& [node, weight] : entries) weights(node) += weight;
  return weights;
}

Eigen::VectorXd BarrierGrid::mean_after_impulse_weights(double y) const {
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(size());
  double sum = 0;
  const auto add = [&](double v, double weight) {
    weights += weight * interpolation_weights_at_state(y, v);
    sum += weight;
  };
  // On a wall the slope of the mean time jumps at v = 0.
  excitation_.for_each_amplitude(-strip_.largest_speed, 0, add);
  excitation_.for_each_amplitude(0, strip_.largest_speed, add);
  return weights / sum;
}

}  // namespace fpkcheck::fd_fpk
