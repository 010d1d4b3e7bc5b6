#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <mutex>

#include "backward/passage/mean_time_certificate.hpp"
#include "base/process/parallel_for.hpp"
#include "numerics/statistics.hpp"

// Proof of the bounds of the mean passage time, docs/functionals.md, section "Guaranteed bounds of
// the mean time". The names V, K, L, a, q, eta, W are those of the proof.
namespace fpkcheck::backward {
namespace {

// Upper bounds of |a|, |a'| and |a''| on an interval of s for the speed a(s) on an arc of the
// grazing trajectory, and a lower bound of a. For the outgoing arc also bounds of q = a / s.
struct GrazingArcSpeedBounds {
  double least, largest, slope, curvature;
  double least_ratio = 0, largest_ratio = 0, ratio_slope = 0, ratio_curvature = 0;
};

class GrazingArcSpeedBoundsFinder {
 public:
  GrazingArcSpeedBoundsFinder(const ImpactOscillator& oscillator, const GrazingTrajectory& grazing)
      : oscillator_(oscillator),
        grazing_(grazing),
        s_max_(std::sqrt(oscillator.barrier)),
        largest_force_slope_(oscillator.stiffness +
                             3 * oscillator.cubic * oscillator.barrier * oscillator.barrier),
        largest_force_curvature_(6 * oscillator.cubic * oscillator.barrier) {
    least_ratio_ = HUGE_VAL;
    for (int i = 1; i <= kRatioPoints; ++i) {
      const double s = s_max_ * i / kRatioPoints;
      least_ratio_ = std::min(least_ratio_, grazing.outgoing.speed(s) / s);
    }
    margin_ = 0.01 * least_ratio_;
    least_ratio_ -= margin_;
    const double force = oscillator.spring_force(oscillator.barrier);
    largest_f_ = force + oscillator.damping * 1.01 * grazing.outgoing.largest_speed();
    f_slope_ =
        2 * s_max_ * largest_force_slope_ + oscillator.damping * 2 * largest_f_ / least_ratio_;
    incoming_slope_ = 2 * s_max_ *
                      (force + oscillator.damping * 1.01 * grazing.incoming.largest_speed()) /
                      (0.99 * grazing.incoming.smallest_speed());
  }

  double force_slope() const { return largest_force_slope_; }
  double force_curvature() const { return largest_force_curvature_; }
  // Returns whether the lower bound of q is valid, and whether the arcs have positive speeds.
  bool is_valid() const {
    const double largest_change = 4.0 / 3 * f_slope_ / (2 * least_ratio_) * s_max_ / kRatioPoints;
    return least_ratio_ > 0 && largest_change < margin_ && incoming_slope_ > 0 &&
           std::isfinite(incoming_slope_);
  }

  // With F = g(b - s^2) + c a: a' = 2 F / q, q^2 = 4 int_0^1 x F(s x) dx, and therefore |(q^2)'| <=
  // 4/3 max |F'| and |(q^2)''| <= max |F''|, where the maxima are over [0, s].
  GrazingArcSpeedBounds outgoing(double s0, double s1) const {
    constexpr double kPad = 1e-6;
    const double c = oscillator_.damping, width = s1 - s0;
    const GrazingArc& arc = grazing_.outgoing;
    GrazingArcSpeedBounds bounds{};
    bounds.least = arc.speed(s0) * (1 - kPad);
    bounds.largest = arc.speed(s1) * (1 + kPad);
    const double ratio_slope = 4.0 / 3 * f_slope_ / (2 * least_ratio_);
    const double first =
        s0 > 0 ? arc.speed(s0) / s0 : std::sqrt(2 * oscillator_.spring_force(oscillator_.barrier));
    const double last = arc.speed(s1) / s1;
    bounds.least_ratio = std::min(first, last) * (1 - kPad) - width * ratio_slope;
    bounds.largest_ratio = std::max(first, last) * (1 + kPad) + width * ratio_slope;
    const double q = bounds.least_ratio;
    const double f = oscillator_.spring_force(oscillator_.barrier - s0 * s0) + c * bounds.largest;
    bounds.slope = 2 * f / q;
    bounds.ratio_slope = 4.0 / 3 * f_slope_ / (2 * q);
    bounds.curvature = 2 * (2 * s1 * largest_force_slope_ + c * bounds.slope) / q +
                       2 * f * bounds.ratio_slope / (q * q);
    const double arc_curvature =
        2 * f_slope_ / least_ratio_ + 2 * largest_f_ * ratio_slope / (least_ratio_ * least_ratio_);
    const double f_curvature =
        2 * largest_force_slope_ + 4 * s1 * s1 * largest_force_curvature_ + c * arc_curvature;
    bounds.ratio_curvature = (f_curvature + 2 * bounds.ratio_slope * bounds.ratio_slope) / (2 * q);
    return bounds;
  }

  // With F = g(b - s^2) - c A: A' = 2 s F / A.
  GrazingArcSpeedBounds incoming(double s0, double s1) const {
    const double c = oscillator_.damping, pad = (s1 - s0 + 1e-6) * incoming_slope_;
    const double first = grazing_.incoming.speed(s0), last = grazing_.incoming.speed(s1);
    GrazingArcSpeedBounds bounds{};
    bounds.least = std::min(first, last) - pad;
    bounds.largest = std::max(first, last) + pad;
    const double f0 = oscillator_.spring_force(oscillator_.barrier - s0 * s0) - c * bounds.least;
    const double f1 = oscillator_.spring_force(oscillator_.barrier - s1 * s1) - c * bounds.largest;
    const double f = std::max(std::abs(f0), std::abs(f1)), a = bounds.least;
    bounds.slope = 2 * s1 * f / a;
    bounds.curvature = 2 * f / a + 2 * s1 * (2 * s1 * largest_force_slope_ + c * bounds.slope) / a +
                       2 * s1 * f * bounds.slope / (a * a);
    return bounds;
  }

 private:
  ImpactOscillator oscillator_;
  GrazingTrajectory grazing_;
  double s_max_, largest_force_slope_, largest_force_curvature_;
  static constexpr int kRatioPoints = 4000;   // at which the constructor computes q
  double margin_;                             // upper bound of the change of q between these points
  double least_ratio_, largest_f_, f_slope_;  // of q, F and |F'| on the outgoing arc
  double incoming_slope_;                     // largest |A'|
};

struct Rectangle {
  double s0, s1, eta0, eta1;
};

// A bicubic polynomial sum c_ij t^i u^j of t = (s - s_origin) / s_width and u = (eta - eta_origin)
// / eta_width.
struct BicubicPatch {
  std::array<std::array<double, 4>, 4> c{};
  double s_origin, eta_origin, s_width, eta_width;

  // Returns the derivative d^m / (ds^i deta^j) at a point.
  double derivative(double s, double eta, int i, int j) const {
    const double t = (s - s_origin) / s_width, u = (eta - eta_origin) / eta_width;
    const auto falling = [](int n, int m) {
      double product = 1;
      for (int k = 0; k < m; ++k) product *= n - k;
      return product;
    };
    double sum = 0;
    for (int a = 3; a >= i; --a) {
      double row = 0;
      for (int b = 3; b >= j; --b) row = row * u + falling(b, j) * at(a, b);
      sum = sum * t + falling(a, i) * row;
    }
    return sum / (std::pow(s_width, i) * std::pow(eta_width, j));
  }
  double at(int a, int b) const {
    return c[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)];
  }
};

// Polynomial patch of a bicubic function on the cell (i, j) of its knots.
BicubicPatch make_patch(const PiecewiseBicubicFunction& f, std::size_t i, std::size_t j) {
  BicubicPatch patch{.s_origin = f.s_knots[i],
                     .eta_origin = f.eta_knots[j],
                     .s_width = f.s_knots[i + 1] - f.s_knots[i],
                     .eta_width = f.eta_knots[j + 1] - f.eta_knots[j]};
  // Power coefficients of the cubic with the values v and the slopes m at 0 and 1
  const auto cubic = [](double v0, double m0, double v1, double m1) {
    return std::array{v0, m0, 3 * (v1 - v0) - 2 * m0 - m1, m0 + m1 - 2 * (v1 - v0)};
  };
  std::array<std::array<double, 4>, 4> by_column;  // powers of t of value, slope, value, slope
  for (std::size_t k = 0; k < 2; ++k) {
    const auto r = static_cast<Eigen::Index>(i), q = static_cast<Eigen::Index>(j + k);
    by_column[2 * k] = cubic(f.value(r, q), patch.s_width * f.s_slope(r, q), f.value(r + 1, q),
                             patch.s_width * f.s_slope(r + 1, q));
    by_column[2 * k + 1] = cubic(f.eta_slope(r, q), patch.s_width * f.mixed_slope(r, q),
                                 f.eta_slope(r + 1, q), patch.s_width * f.mixed_slope(r + 1, q));
    for (double& value : by_column[2 * k + 1]) value *= patch.eta_width;
  }
  for (std::size_t a = 0; a < 4; ++a)
    patch.c[a] = cubic(by_column[0][a], by_column[1][a], by_column[2][a], by_column[3][a]);
  return patch;
}

std::size_t cell_index(const std::vector<double>& knots, double x) {
  const auto above = std::ranges::upper_bound(knots, x) - knots.begin();
  return static_cast<std::size_t>(
      std::clamp<std::ptrdiff_t>(above - 1, 0, static_cast<std::ptrdiff_t>(knots.size()) - 2));
}

// V_s / s, for a patch at s = 0 with V_s = 0 at s = 0.
BicubicPatch s_slope_over_s(const BicubicPatch& patch) {
  BicubicPatch result = patch;
  result.c = {};
  for (std::size_t b = 0; b < 4; ++b) {
    result.c[0][b] = 2 * patch.c[2][b] / (patch.s_width * patch.s_width);
    result.c[1][b] = 3 * patch.c[3][b] / (patch.s_width * patch.s_width);
  }
  return result;
}

// V_eta / s, for a patch at s = 0 with V_eta = 0 at s = 0.
BicubicPatch eta_slope_over_s(const BicubicPatch& patch) {
  BicubicPatch result = patch;
  result.c = {};
  for (std::size_t a = 1; a < 4; ++a) {
    for (std::size_t b = 1; b < 4; ++b)
      result.c[a - 1][b - 1] =
          static_cast<double>(b) * patch.c[a][b] / (patch.eta_width * patch.s_width);
  }
  return result;
}

// Upper bounds of the derivatives |d^(i+j) V / (ds^i deta^j)| of a patch on a rectangle, and the
// range of V, from the Taylor polynomial at the centre.
struct BicubicPatchDerivativeBounds {
  std::array<std::array<double, 4>, 4> derivative;
  double centre, low, high;

  BicubicPatchDerivativeBounds(const BicubicPatch& patch, const Rectangle& r) {
    auto c = patch.c;
    const double t = ((r.s0 + r.s1) / 2 - patch.s_origin) / patch.s_width;
    const double u = ((r.eta0 + r.eta1) / 2 - patch.eta_origin) / patch.eta_width;
    const double dt = (r.s1 - r.s0) / 2 / patch.s_width;
    const double du = (r.eta1 - r.eta0) / 2 / patch.eta_width;
    for (std::size_t p = 0; p < 3; ++p) {
      for (std::size_t a = 3; a-- > p;) {
        for (std::size_t b = 0; b < 4; ++b) c[a][b] += t * c[a + 1][b];
      }
    }
    for (auto& row : c) {
      for (std::size_t p = 0; p < 3; ++p) {
        for (std::size_t b = 3; b-- > p;) row[b] += u * row[b + 1];
      }
    }
    constexpr std::array<std::array<double, 4>, 4> kFalling = {
        {{1, 1, 1, 1}, {0, 1, 2, 3}, {0, 0, 2, 6}, {0, 0, 0, 6}}};
    std::array<double, 4> t_powers{1}, u_powers{1}, s_scale{1}, eta_scale{1};
    for (std::size_t k = 1; k < 4; ++k) {
      t_powers[k] = t_powers[k - 1] * dt;
      u_powers[k] = u_powers[k - 1] * du;
      s_scale[k] = s_scale[k - 1] / patch.s_width;
      eta_scale[k] = eta_scale[k - 1] / patch.eta_width;
    }
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 4; ++j) {
        double sum = 0;
        for (std::size_t a = i; a < 4; ++a) {
          for (std::size_t b = j; b < 4; ++b)
            sum += std::abs(c[a][b]) * kFalling[i][a] * kFalling[j][b] * t_powers[a - i] *
                   u_powers[b - j];
        }
        derivative[i][j] = sum * s_scale[i] * eta_scale[j];
      }
    }
    centre = c[0][0];
    const double radius = derivative[0][0] - std::abs(centre);
    low = centre - radius;
    high = centre + radius;
  }
  double operator()(std::size_t i, std::size_t j) const { return derivative[i][j]; }
};

// Bounds of the speed W(s, eta) of a region on a rectangle: its range, and upper bounds of the
// magnitudes of its derivatives.
struct SpeedBoundsOnRectangle {
  double low, high, s, ss, eta, eta2, eta3, s_eta, ss_eta;

  SpeedBoundsOnRectangle(Region region, const ImpactOscillator& oscillator,
                         const GrazingArcSpeedBounds& arc, const Rectangle& r) {
    if (is_trapped_region(region)) {  // W = eta a(s)
      low = r.eta0 * arc.least;
      high = r.eta1 * arc.largest;
      s = r.eta1 * arc.slope;
      ss = r.eta1 * arc.curvature;
      eta = arc.largest;
      eta2 = eta3 = 0;
      s_eta = arc.slope;
      ss_eta = arc.curvature;
      return;
    }
    // W^2 = kappa eta^2 + a^2
    const double kappa =
        region == exit_down ? 1 / (oscillator.restitution * oscillator.restitution) : 1;
    low = std::sqrt(kappa * r.eta0 * r.eta0 + arc.least * arc.least);
    high = std::sqrt(kappa * r.eta1 * r.eta1 + arc.largest * arc.largest);
    const double share = std::min(1.0, arc.largest / low);
    s = share * arc.slope;
    ss = (arc.slope * arc.slope + arc.largest * arc.curvature + s * s) / low;
    eta = std::min(std::sqrt(kappa), kappa * r.eta1 / low);
    eta2 = kappa * share * share / low;
    eta3 = 3 * eta2 * eta / low;
    s_eta = eta * s / low;
    ss_eta = eta * (2 * s * s / low + ss) / low;
  }
};

double normal_tail(double x) { return std::erfc(x / std::sqrt(2.0)) / 2; }

// Values on a uniform grid of velocities.
struct UniformVelocityGrid {
  double limit;
  int count;

  double step() const { return 2 * limit / (count - 1); }
  double at(int j) const { return -limit + step() * j; }
  double position(double v) const { return (v + limit) / step(); }
};

// Density of the Gaussian amplitude, and upper bounds of the magnitudes of its value and of its
// first two derivatives for amplitudes in a range.
struct AmplitudeDensityBounds {
  double value, slope, curvature;

  AmplitudeDensityBounds(double amplitude_low, double amplitude_high, double deviation) {
    const double nearest = std::max({0.0, amplitude_low, -amplitude_high}) / deviation;
    const double farthest = std::max(std::abs(amplitude_low), std::abs(amplitude_high)) / deviation;
    const double at_nearest = numerics::normal_density(nearest),
                 at_farthest = numerics::normal_density(farthest);
    value = at_nearest / deviation;
    // x phi(x) has its maximum at x = 1, and (x^2 - 1) phi(x) at sqrt(3).
    slope = nearest <= 1 && farthest >= 1 ? 0.24197072451914337
                                          : std::max(nearest * at_nearest, farthest * at_farthest);
    slope /= deviation * deviation;
    curvature = at_nearest * std::max(std::abs(nearest * nearest - 1), farthest * farthest - 1);
    if (nearest >= 1) {
      curvature = nearest <= 1.7320508 && farthest >= 1.7320508
                      ? 0.17852
                      : std::max((nearest * nearest - 1) * at_nearest,
                                 (farthest * farthest - 1) * at_farthest);
    }
    curvature /= deviation * deviation * deviation;
  }
};

class CertificateVerification {
 public:
  CertificateVerification(const MeanPassageTimeCertificate& certificate,
                          const ImpactOscillator& oscillator, double refinement,
                          const base::Deadline& deadline)
      : certificate_(certificate),
        oscillator_(oscillator),
        deadline_(deadline),
        grazing_(oscillator),
        arcs_(oscillator, grazing_),
        s_max_(std::sqrt(oscillator.barrier)),
        largest_eta_(certificate.regions[exit_up].eta_knots.back()),
        velocities_{1.02 * std::hypot(largest_eta_ / oscillator.restitution,
                                      grazing_.incoming.largest_speed()) +
                        oscillator.deviation,
                    0} {
    make_grid(refinement);
    bound_values();
  }

  VerifiedPassageTimeBound run();

 private:
  struct Line {
    std::vector<double> mean;   // K V at the velocities
    std::vector<double> error;  // bound of the quadrature error, on the coarse velocities
  };
  struct MeanCurvature {
    std::vector<double> ss, sv;  // bounds of |d^2 K V / ds^2| and |d^2 K V / (ds dv)|
  };
  static constexpr int kCoarse = 3;      // velocities per coarse velocity
  static constexpr double kReach = 8.5;  // in standard deviations; the probability beyond is 2e-17

  void make_grid(double refinement);
  void bound_values();
  BicubicPatch patch(Region region, const Rectangle& r) const {
    const PiecewiseBicubicFunction& f = certificate_.regions[region];
    return make_patch(f, cell_index(f.s_knots, (r.s0 + r.s1) / 2),
                      cell_index(f.eta_knots, (r.eta0 + r.eta1) / 2));
  }
  const std::vector<double>& eta_grid(Region region) const {
    return is_trapped_region(region) ? trapped_eta_ : exit_eta_;
  }
  int coarse_count() const { return (velocities_.count + kCoarse - 1) / kCoarse; }
  // Calls visit(coarse index, kernel bounds) for the coarse velocities that amplitudes connect to
  // the speeds of a region. Each coarse velocity represents its neighbourhood.
  template <class Visit>
  void visit_kernels(Region region, double low, double high, const Visit& visit) const;
  void compute_mean_on_line(double s, Line& line) const;
  MeanCurvature bound_mean_curvature(double s0, double s1) const;
  double mean_at(const Line& line, double v) const;
  double coarse_bound(const std::vector<double>& values, double v) const;
  double residual_without_mean(Region region, const BicubicPatch& patch, double s,
                               double eta) const;
  bool verify_rectangle(Region region, const Rectangle& r, const GrazingArcSpeedBounds& arc,
                        const Line& left, const Line& right, const MeanCurvature& curvature,
                        bool& can_bisect) const;

  const MeanPassageTimeCertificate& certificate_;
  ImpactOscillator oscillator_;
  const base::Deadline& deadline_;
  GrazingTrajectory grazing_;
  GrazingArcSpeedBoundsFinder arcs_;
  double s_max_, largest_eta_;
  UniformVelocityGrid velocities_;
  std::vector<double> s_grid_, trapped_eta_, exit_eta_;
  double value_low_ = 0, value_high_ = 0, outer_value_ = 0;
  double strip_low_ = 0, strip_high_ = 0;  // range of V in the strip at the barrier
  // Bounds of |K V_v|, |K V_vv| and of the interpolation error of K V in v
  double mean_slope_ = 0, mean_curvature_ = 0, interpolation_error_ = 0;
};

void CertificateVerification::make_grid(double refinement) {
  const auto refine = [](const std::vector<double>& knots, const auto& longest) {
    std::vector<double> grid;
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
      const double width = knots[i + 1] - knots[i];
      const int parts = static_cast<int>(std::ceil(width / longest(knots[i])));
      for (int k = 0; k < parts; ++k) grid.push_back(knots[i] + width * k / parts);
    }
    grid.push_back(knots.back());
    return grid;
  };
  std::vector<double> knots = certificate_.regions[trapped_up].s_knots;
  const auto& others = certificate_.regions[exit_up].s_knots;
  knots.insert(knots.end(), others.begin(), others.end());
  std::ranges::sort(knots);
  const double s_scale = s_max_ / 1.2247;
  knots.erase(std::unique(knots.begin(), knots.end(),
                          [&](double a, double b) { return b - a < 1e-12 * s_scale; }),
              knots.end());
  s_grid_ = refine(knots, [&](double s) {
    return std::min(0.004 * s_scale, std::max(s / 12, 0.0002 * s_scale)) / refinement;
  });
  trapped_eta_ = refine(certificate_.regions[trapped_up].eta_knots,
                        [&](double) { return 0.005 / refinement; });
  const double speed = grazing_.outgoing.speed(s_max_) / 1.7;
  exit_eta_ = refine(certificate_.regions[exit_up].eta_knots, [&](double eta) {
    const double e = eta / speed;
    return speed * (e < 0.3 ? 0.005 : e < 1.2 ? 0.008 : e < 2 ? 0.016 : 0.03) / refinement;
  });
}

void CertificateVerification::bound_values() {
  constexpr int kParts = 4;
  value_low_ = strip_low_ = 0;
  value_high_ = strip_high_ = 0;
  for (const Region region : kRegions) {
    const PiecewiseBicubicFunction& f = certificate_.regions[region];
    for (std::size_t i = 0; i + 1 < f.s_knots.size(); ++i) {
      for (std::size_t j = 0; j + 1 < f.eta_knots.size(); ++j) {
        const BicubicPatch cell = make_patch(f, i, j);
        for (int p = 0; p < kParts; ++p) {
          for (int q = 0; q < kParts; ++q) {
            const double s = cell.s_origin + cell.s_width * p / kParts;
            const double eta = cell.eta_origin + cell.eta_width * q / kParts;
            const BicubicPatchDerivativeBounds bounds(
                cell, {s, s + cell.s_width / kParts, eta, eta + cell.eta_width / kParts});
            value_low_ = std::min(value_low_, bounds.low);
            value_high_ = std::max(value_high_, bounds.high);
            if (region == exit_up && i == 0) {
              strip_low_ = std::min(strip_low_, bounds.low);
              strip_high_ = std::max(strip_high_, bounds.high);
            }
          }
        }
      }
    }
  }
  const double excess = 1 / (largest_eta_ - 2 * oscillator_.arrival_rate * oscillator_.barrier);
  outer_value_ =
      certificate_.is_upper ? value_high_ + 2 * excess * oscillator_.barrier : value_low_;
  // With the deviation d of the impulses, |d^n K V / dv^n| <= d^-n E|He_n| times half of the
  // oscillation of V. E|He_1| < 0.798, E|He_2| < 0.968, E|He_4| <= sqrt(4!).
  const double half =
      (std::max(value_high_, outer_value_) - std::min(value_low_, outer_value_)) / 2;
  const double deviation = oscillator_.deviation;
  mean_slope_ = 0.798 * half / deviation;
  mean_curvature_ = 0.968 * half / (deviation * deviation);
  const double fourth = 4.9 * half / std::pow(deviation, 4);
  const double longest = 0.095 * deviation;
  velocities_.count = 2 * static_cast<int>(std::ceil(velocities_.limit / longest)) + 1;
  // Cubic interpolation at the two nodes on each side: the error is 3/128 h^4 max|f''''|.
  interpolation_error_ = 3.0 / 128 * std::pow(velocities_.step(), 4) * fourth;
}

template <class Visit>
void CertificateVerification::visit_kernels(Region region, double low, double high,
                                            const Visit& visit) const {
  const double v_low = is_incoming_region(region) ? -high : low;
  const double v_high = is_incoming_region(region) ? -low : high;
  const double reach = kReach * oscillator_.deviation;
  const double width = velocities_.step() * kCoarse;
  const int first = std::max(0, static_cast<int>((v_low - reach + velocities_.limit) / width));
  const int last = std::min(coarse_count() - 1,
                            static_cast<int>((v_high + reach + velocities_.limit) / width) + 1);
  for (int j = first; j <= last; ++j) {
    const double v = velocities_.at(kCoarse * j), radius = 0.5000001 * width;
    visit(static_cast<std::size_t>(j),
          AmplitudeDensityBounds(v_low - v - radius, v_high - v + radius, oscillator_.deviation));
  }
}

// Computes K V at y = b - s^2 by the midpoint rule in eta. The error bounds are h^3 / 24 times the
// second derivatives of the integrand V phi(W - v) W_eta with respect to eta.
void CertificateVerification::compute_mean_on_line(double s, Line& line) const {
  const double deviation = oscillator_.deviation;
  line.mean.assign(static_cast<std::size_t>(velocities_.count), 0);
  line.error.assign(static_cast<std::size_t>(coarse_count()), 0);
  for (const Region region : kRegions) {
    // At s = 0 the region trapped_up has no width, and V is 0 in the region exit_up.
    if (s == 0 && !is_incoming_region(region)) continue;
    const GrazingArcSpeedBounds arc =
        is_incoming_region(region) ? arcs_.incoming(s, s) : arcs_.outgoing(s, s);
    const double kappa =
        region == exit_down ? 1 / (oscillator_.restitution * oscillator_.restitution) : 1;
    const double a = (is_incoming_region(region) ? grazing_.incoming : grazing_.outgoing).speed(s);
    const auto& grid = eta_grid(region);
    for (std::size_t m = 0; m + 1 < grid.size(); ++m) {
      const double width = grid[m + 1] - grid[m], eta = (grid[m] + grid[m + 1]) / 2;
      const Rectangle r{s, s, grid[m], grid[m + 1]};
      const BicubicPatchDerivativeBounds V(patch(region, r), r);
      const SpeedBoundsOnRectangle W(region, oscillator_, arc, r);
      const double speed =
          is_trapped_region(region) ? eta * a : std::sqrt(kappa * eta * eta + a * a);
      const double weight =
          V.centre * (is_trapped_region(region) ? a : kappa * eta / speed) * width / deviation;
      const double v = is_incoming_region(region) ? -speed : speed;
      // The Gaussian density at equidistant velocities, from the nearest one outward: consecutive
      // values have ratios that form a geometric sequence.
      const double h = velocities_.step() / deviation;
      const int nearest = std::clamp(static_cast<int>(std::lround(velocities_.position(v))), 0,
                                     velocities_.count - 1);
      const double x = (velocities_.at(nearest) - v) / deviation;
      const double quotient = std::exp(-h * h);
      for (const int direction : {1, -1}) {
        double density = numerics::normal_density(x) * weight;
        double ratio = std::exp(-h * (direction * x + h / 2));
        for (int j = nearest; j >= 0 && j < velocities_.count &&
                              std::abs(velocities_.at(j) - v) < kReach * deviation;
             j += direction) {
          if (direction == 1 || j != nearest) line.mean[static_cast<std::size_t>(j)] += density;
          density *= ratio;
          ratio *= quotient;
        }
      }
      const double factor = width * width * width / 24;
      const double with_value =
          factor * (V(0, 2) * W.eta + 2 * V(0, 1) * W.eta2 + V(0, 0) * W.eta3);
      const double with_slope =
          factor * (2 * V(0, 1) * W.eta * W.eta + 3 * V(0, 0) * W.eta * W.eta2);
      const double with_curvature = factor * V(0, 0) * W.eta * W.eta * W.eta;
      visit_kernels(region, W.low, W.high,
                    [&](std::size_t j, const AmplitudeDensityBounds& kernel) {
                      line.error[j] += with_value * kernel.value + with_slope * kernel.slope +
                                       with_curvature * kernel.curvature;
                    });
    }
  }
  const double up = std::hypot(largest_eta_, grazing_.outgoing.speed(s));
  const double down =
      std::hypot(largest_eta_ / oscillator_.restitution, grazing_.incoming.speed(s));
  for (int j = 0; j < velocities_.count; ++j) {
    const double v = velocities_.at(j);
    line.mean[static_cast<std::size_t>(j)] +=
        outer_value_ * (normal_tail((up - v) / deviation) + normal_tail((down + v) / deviation));
  }
}

CertificateVerification::MeanCurvature CertificateVerification::bound_mean_curvature(
    double s0, double s1) const {
  const auto count = static_cast<std::size_t>(coarse_count());
  MeanCurvature bounds{std::vector<double>(count, 0), std::vector<double>(count, 0)};
  const GrazingArcSpeedBounds outgoing = arcs_.outgoing(s0, s1), incoming = arcs_.incoming(s0, s1);
  const double ds = s1 - s0;
  for (const Region region : kRegions) {
    const GrazingArcSpeedBounds& arc = is_incoming_region(region) ? incoming : outgoing;
    const auto& grid = eta_grid(region);
    const bool is_in_strip =
        region == exit_up && s1 <= certificate_.regions[exit_up].s_knots[1] * (1 + 1e-9);
    const double corner = 0.03 * grazing_.outgoing.speed(s_max_);
    for (std::size_t m = 0; m + 1 < grid.size(); ++m) {
      const Rectangle r{s0, s1, grid[m], grid[m + 1]};
      const double h = grid[m + 1] - grid[m];
      const BicubicPatchDerivativeBounds V(patch(region, r), r);
      if (is_in_strip && r.eta0 < corner) {
        // Near the grazing point the derivatives are unbounded. The contribution to K V differs
        // from its linear interpolation by at most its range.
        const double high = std::hypot(r.eta1, arc.largest);
        const double range = 2 * V(0, 0) * (high - r.eta0);
        const double equivalent_curvature = 8 * range / (ds * ds);
        visit_kernels(region, r.eta0, high,
                      [&](std::size_t j, const AmplitudeDensityBounds& kernel) {
                        bounds.ss[j] += equivalent_curvature * kernel.value;
                      });
        continue;
      }
      const SpeedBoundsOnRectangle W(region, oscillator_, arc, r);
      const double ss_value = h * (V(2, 0) * W.eta + 2 * V(1, 0) * W.s_eta + V(0, 0) * W.ss_eta);
      const double ss_slope =
          h * (2 * V(1, 0) * W.s * W.eta + V(0, 0) * (W.ss * W.eta + 2 * W.s * W.s_eta));
      const double ss_curvature = h * V(0, 0) * W.s * W.s * W.eta;
      const double sv_slope = h * (V(1, 0) * W.eta + V(0, 0) * W.s_eta);
      const double sv_curvature = h * V(0, 0) * W.s * W.eta;
      visit_kernels(
          region, W.low, W.high, [&](std::size_t j, const AmplitudeDensityBounds& kernel) {
            bounds.ss[j] +=
                ss_value * kernel.value + ss_slope * kernel.slope + ss_curvature * kernel.curvature;
            bounds.sv[j] += sv_slope * kernel.slope + sv_curvature * kernel.curvature;
          });
    }
    if (is_trapped_region(region)) continue;
    // The probability of the states with eta > largest_eta
    const SpeedBoundsOnRectangle W(region, oscillator_, arc, {s0, s1, largest_eta_, largest_eta_});
    visit_kernels(region, W.low, W.high, [&](std::size_t j, const AmplitudeDensityBounds& kernel) {
      const double outer = std::abs(outer_value_);
      bounds.ss[j] += outer * (kernel.slope * W.s * W.s + kernel.value * W.ss);
      bounds.sv[j] += outer * kernel.slope * W.s;
    });
  }
  return bounds;
}

double CertificateVerification::mean_at(const Line& line, double v) const {
  const double x = velocities_.position(v);
  const int first = std::clamp(static_cast<int>(x) - 1, 0, velocities_.count - 4);
  const double t = x - first;
  const double* f = &line.mean[static_cast<std::size_t>(first)];
  return -f[0] * (t - 1) * (t - 2) * (t - 3) / 6 + f[1] * t * (t - 2) * (t - 3) / 2 -
         f[2] * t * (t - 1) * (t - 3) / 2 + f[3] * t * (t - 1) * (t - 2) / 6;
}

double CertificateVerification::coarse_bound(const std::vector<double>& values, double v) const {
  const int j =
      std::clamp(static_cast<int>(velocities_.position(v) / kCoarse), 0, coarse_count() - 2);
  return std::max(values[static_cast<std::size_t>(j)], values[static_cast<std::size_t>(j + 1)]);
}

// Returns s' V_s + eta' V_eta + 1 - lambda V, with s' = -v / (2 s).
double CertificateVerification::residual_without_mean(Region region, const BicubicPatch& cell,
                                                      double s, double eta) const {
  const double c = oscillator_.damping, y = oscillator_.barrier - s * s;
  const double force = oscillator_.spring_force(y);
  const double a = (is_incoming_region(region) ? grazing_.incoming : grazing_.outgoing).speed(s);
  const bool is_first = cell.s_origin == 0;
  const double v = region_velocity(oscillator_, grazing_, region, s, eta);
  const double eta_slope = cell.derivative(s, eta, 0, 1);
  double along_s, along_eta;
  if (region == trapped_up) {
    const double ratio =
        s > 0 ? a / s : std::sqrt(2 * oscillator_.spring_force(oscillator_.barrier));
    along_s = -eta * ratio / 2 * cell.derivative(s, eta, 1, 0);
    const double slope_over_speed =
        (is_first ? eta_slope_over_s(cell).derivative(s, eta, 0, 0) : eta_slope / s) / ratio;
    along_eta = -force * (1 - eta * eta) * slope_over_speed - c * eta * (1 - eta) * eta_slope;
  } else {
    along_s = is_first ? -v / 2 * s_slope_over_s(cell).derivative(s, eta, 0, 0)
                       : -v / (2 * s) * cell.derivative(s, eta, 1, 0);
    along_eta = region == trapped_down
                    ? (force * (1 - eta * eta) / a - c * eta * (1 - eta)) * eta_slope
                    : -c * eta * std::abs(v) / (std::abs(v) + a) * eta_slope;
  }
  return along_s + along_eta + 1 - oscillator_.arrival_rate * cell.derivative(s, eta, 0, 0);
}

bool CertificateVerification::verify_rectangle(Region region, const Rectangle& r,
                                               const GrazingArcSpeedBounds& arc, const Line& left,
                                               const Line& right, const MeanCurvature& curvature,
                                               bool& can_bisect) const {
  const BicubicPatch cell = patch(region, r);
  const BicubicPatchDerivativeBounds V(cell, r);
  const SpeedBoundsOnRectangle W(region, oscillator_, arc, r);
  const bool is_first = cell.s_origin == 0;
  const double c = oscillator_.damping, rate = oscillator_.arrival_rate;
  // Bounds of the second derivatives of the residual in s and in eta
  double in_s = rate * V(2, 0), in_eta = rate * V(0, 2);
  // The product f V_j, with bounds of f and of its derivatives
  const auto add = [&](double f, double f_s, double f_ss, double f_eta, double f_eta2,
                       const BicubicPatchDerivativeBounds& g, std::size_t i, std::size_t j) {
    const auto at = [&](std::size_t m, std::size_t n) { return m < 4 && n < 4 ? g(m, n) : 0.0; };
    in_s += f_ss * at(i, j) + 2 * f_s * at(i + 1, j) + f * at(i + 2, j);
    in_eta += f_eta2 * at(i, j) + 2 * f_eta * at(i, j + 1) + f * at(i, j + 2);
  };
  const double s0 = r.s0;
  if (region == trapped_up) {
    add(r.eta1 * arc.largest_ratio / 2, r.eta1 * arc.ratio_slope / 2,
        r.eta1 * arc.ratio_curvature / 2, arc.largest_ratio / 2, 0, V, 1, 0);
  } else if (is_first) {
    add(W.high / 2, W.s / 2, W.ss / 2, W.eta / 2, W.eta2 / 2,
        BicubicPatchDerivativeBounds(s_slope_over_s(cell), r), 0, 0);
  } else {
    add(W.high / (2 * s0), W.s / (2 * s0) + W.high / (2 * s0 * s0),
        W.ss / (2 * s0) + W.s / (s0 * s0) + W.high / (s0 * s0 * s0), W.eta / (2 * s0),
        W.eta2 / (2 * s0), V, 1, 0);
  }
  if (is_trapped_region(region)) {
    // g (1 - eta^2) / a, or g (1 - eta^2) / q for V_eta / s
    const double force = oscillator_.spring_force(oscillator_.barrier - s0 * s0);
    const double force_s = 2 * r.s1 * arcs_.force_slope();
    const double force_ss = 2 * arcs_.force_slope() + 4 * r.s1 * r.s1 * arcs_.force_curvature();
    const bool over_s = region == trapped_up && is_first;
    const double a = over_s ? arc.least_ratio : arc.least;
    const double a_s = over_s ? arc.ratio_slope : arc.slope;
    const double a_ss = over_s ? arc.ratio_curvature : arc.curvature;
    const double inverse = 1 / a, inverse_s = a_s / (a * a),
                 inverse_ss = 2 * a_s * a_s / (a * a * a) + a_ss / (a * a);
    const double f = force * inverse, f_s = force_s * inverse + force * inverse_s,
                 f_ss = force_ss * inverse + 2 * force_s * inverse_s + force * inverse_ss;
    const double shape = 1 - r.eta0 * r.eta0;
    add(f * shape, f_s * shape, f_ss * shape, f * 2 * r.eta1, f * 2,
        over_s ? BicubicPatchDerivativeBounds(eta_slope_over_s(cell), r) : V, 0, over_s ? 0 : 1);
    add(c / 4, 0, 0, c, 2 * c, V, 0, 1);
  } else {
    // c eta (1 - a / (W + a))
    const double sum = W.low + arc.least, square = sum * sum;
    const double share_s = (arc.slope * W.high + arc.largest * W.s) / square;
    const double share_ss = (arc.curvature * W.high + arc.largest * W.ss) / square +
                            2 * share_s * (W.s + arc.slope) / sum;
    const double share_eta = arc.largest * W.eta / square;
    const double share_eta2 = arc.largest * W.eta2 / square + 2 * share_eta * W.eta / sum;
    add(c * r.eta1, c * r.eta1 * share_s, c * r.eta1 * share_ss, c + c * r.eta1 * share_eta,
        2 * c * share_eta + c * r.eta1 * share_eta2, V, 0, 1);
  }
  // K V as a function of s and of v = +-W(s, eta)
  const double sign = is_incoming_region(region) ? -1 : 1;
  double ss = 0, sv = 0;
  // Each bound is valid between two neighbouring coarse velocities.
  const double coarse_step = kCoarse * velocities_.step();
  for (double speed = W.low;; speed = std::min(speed + coarse_step, W.high)) {
    ss = std::max(ss, coarse_bound(curvature.ss, sign * speed));
    sv = std::max(sv, coarse_bound(curvature.sv, sign * speed));
    if (!(speed < W.high)) break;
  }
  in_s += rate * (ss + 2 * sv * W.s + mean_curvature_ * W.s * W.s + mean_slope_ * W.ss);
  in_eta += rate * (mean_curvature_ * W.eta * W.eta + mean_slope_ * W.eta2);

  // A function differs from its bilinear interpolation by at most these terms.
  const double ds = r.s1 - r.s0, deta = r.eta1 - r.eta0;
  const double between_s = in_s * ds * ds / 8, between_eta = in_eta * deta * deta / 8;
  can_bisect = between_eta > 0.2 * (between_s + between_eta);
  const double bound = between_s + between_eta;
  for (const bool is_left : {true, false}) {
    const double s = is_left ? r.s0 : r.s1;
    const Line& line = is_left ? left : right;
    // Rounding errors, and the error of the arcs of the grazing trajectory
    const double tolerance = 1e-5 + 1e-6 / std::max(s / s_max_, 1e-4);
    for (const double eta : {r.eta0, r.eta1}) {
      const double v = region_velocity(oscillator_, grazing_, region, s, eta);
      const double residual = residual_without_mean(region, cell, s, eta) + rate * mean_at(line, v);
      constexpr double kLebesgue = 1.63;  // of cubic interpolation
      const double step = velocities_.step();
      const double error =
          interpolation_error_ +
          kLebesgue * std::max({coarse_bound(line.error, v), coarse_bound(line.error, v - 2 * step),
                                coarse_bound(line.error, v + 2 * step)});
      const double margin =
          (certificate_.is_upper ? -residual : residual) - rate * error - tolerance;
      if (!(margin >= bound)) return false;
    }
  }
  return true;
}

VerifiedPassageTimeBound CertificateVerification::run() {
  VerifiedPassageTimeBound result;
  if (!arcs_.is_valid() || !(largest_eta_ > 2 * oscillator_.arrival_rate * oscillator_.barrier) ||
      !std::isfinite(value_high_ - value_low_)) {
    return result;
  }
  std::vector<Line> lines(s_grid_.size());
  base::parallel_for(lines.size(), base::kOneThreadPerProcessor, [&](std::size_t i) {
    if (!deadline_.has_deadline_passed()) compute_mean_on_line(s_grid_[i], lines[i]);
  });
  const double strip_end = certificate_.regions[exit_up].s_knots[1];
  std::atomic<bool> has_failed = false;
  base::parallel_for(lines.size() - 1, base::kOneThreadPerProcessor, [&](std::size_t i) {
    if (has_failed || deadline_.has_deadline_passed()) return;
    const double s0 = s_grid_[i], s1 = s_grid_[i + 1];
    const MeanCurvature curvature = bound_mean_curvature(s0, s1);
    const GrazingArcSpeedBounds outgoing = arcs_.outgoing(s0, s1),
                                incoming = arcs_.incoming(s0, s1);
    for (const Region region : kRegions) {
      // The proof does not need the inequality in the strip at the barrier.
      if (region == exit_up && s1 <= strip_end * (1 + 1e-9)) continue;
      struct Part {
        Rectangle rectangle;
        int depth;
      };
      std::vector<Part> parts;
      const auto& grid = eta_grid(region);
      for (std::size_t m = 0; m + 1 < grid.size(); ++m)
        parts.push_back({{s0, s1, grid[m], grid[m + 1]}, 0});
      while (!parts.empty()) {
        const auto [r, depth] = parts.back();
        parts.pop_back();
        constexpr int kMaxDepth = 6;
        bool can_bisect = false;
        const bool is_verified =
            verify_rectangle(region, r, is_incoming_region(region) ? incoming : outgoing, lines[i],
                             lines[i + 1], curvature, can_bisect);
        if (!is_verified && can_bisect && depth < kMaxDepth) {
          const double middle = (r.eta0 + r.eta1) / 2;
          parts.push_back({{s0, s1, r.eta0, middle}, depth + 1});
          parts.push_back({{s0, s1, middle, r.eta1}, depth + 1});
          continue;
        }
        if (is_verified) continue;
        has_failed = true;
        return;
      }
    }
  });
  if (has_failed || deadline_.has_deadline_passed()) return result;
  result.is_proved = true;

  // The start at rest: 1 / lambda + K V at (0, 0)
  const double rate = oscillator_.arrival_rate;
  const Line& wall = lines.back();
  constexpr double kTolerance = 1e-5;
  const double error = interpolation_error_ +
                       1.63 * std::max(coarse_bound(wall.error, 0),
                                       coarse_bound(wall.error, -2 * velocities_.step())) +
                       kTolerance;
  const double mean = 1 / rate + mean_at(wall, 0);
  if (certificate_.is_upper) {
    // From the strip the motion passes the barrier within this time, unless an impulse arrives.
    const double strip_time = 2 * strip_end / arcs_.outgoing(0, strip_end).least_ratio;
    const double largest_mean = (outer_value_ - strip_low_ + strip_time) / (1 - rate * strip_time);
    result.bound =
        mean + error - strip_low_ + strip_time * (1 + rate * std::max(largest_mean, 0.0));
    if (!(rate * strip_time < 1)) result.is_proved = false;
  } else {
    result.bound = mean - error - strip_high_;
  }
  return result;
}

}  // namespace

VerifiedPassageTimeBound verify_certificate(const MeanPassageTimeCertificate& certificate,
                                            const ImpactOscillator& oscillator, double refinement,
                                            const base::Deadline& deadline) {
  const bool is_supported = oscillator.stiffness > 0 && oscillator.cubic >= 0 &&
                            oscillator.damping >= 0 && oscillator.restitution > 0 &&
                            oscillator.restitution <= 1;
  if (!is_supported) return {};
  return CertificateVerification(certificate, oscillator, refinement, deadline).run();
}

}  // namespace fpkcheck::backward
