#include "methods/given/own_density.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "methods/given/bin_errors.hpp"
#include "methods/look.hpp"
#include "parameters/input_error.hpp"
#include "problem/energy_balance.hpp"
#include "problem/motion_balances.hpp"
#include "transform/balance_residuals.hpp"

namespace fpkcheck::methods {
namespace {

using transform::Moments;
using transform::Solution;
using transform::Status;
using transform::Variable;

constexpr double kNotKnown = std::numeric_limits<double>::quiet_NaN();

// Relative to the peak, or to 1.
constexpr double kNegative = 1e-6, kCutOff = 1e-4, kOffOne = 1e-3;

// The edges, and beyond the last one bins of the last width to 10/7 of it.
std::vector<double> extended(std::vector<double> edges) {
  const double last = edges.back(), width = last - edges[edges.size() - 2];
  const auto more = static_cast<int>(std::lround(last * 3 / 7 / width));
  for (int k = 1; k <= more; ++k) edges.push_back(last + k * width);
  return edges;
}

std::vector<double> mirrored(const std::vector<double>& edges) {
  std::vector<double> both;
  for (auto edge = edges.rbegin(); edge != edges.rend() && *edge > 0; ++edge) {
    both.push_back(-*edge);
  }
  both.insert(both.end(), edges.begin(), edges.end());
  return both;
}

constexpr std::size_t kPointsOfACell = 3;
constexpr std::array<double, kPointsOfACell> kShares{5.0 / 18, 8.0 / 18, 5.0 / 18};

void add_points(const std::vector<double>& edges, std::vector<double>& points) {
  for (std::size_t k = 0; k + 1 < edges.size(); ++k) {
    const double centre = (edges[k] + edges[k + 1]) / 2, half = (edges[k + 1] - edges[k]) / 2;
    for (const double at : {-std::sqrt(0.6), 0.0, std::sqrt(0.6)}) {
      points.push_back(centre + at * half);
    }
  }
}

std::vector<double> weights(const std::vector<double>& edges) {
  std::vector<double> all;
  for (std::size_t k = 0; k + 1 < edges.size(); ++k) {
    for (const double share : kShares) all.push_back(share * (edges[k + 1] - edges[k]));
  }
  return all;
}

// A density's values with the rule that integrates them.
class Integrals {
 public:
  Integrals(const DensityPoints& points, const std::vector<double>& values)
      : points_(points),
        values_(values),
        weight_y_(weights(points.y_edges())),
        weight_v_(weights(points.v_edges())) {}

  /// int g(y, v) p(y, v) dy dv.
  template <class Function>
  double of(const Function& g) const {
    double sum = 0;
    for (std::size_t i = 0; i < weight_y_.size(); ++i) {
      for (std::size_t j = 0; j < weight_v_.size(); ++j) {
        sum +=
            weight_y_[i] * weight_v_[j] * value(i + 1, j) * g(points_.y()[i + 1], points_.v()[j]);
      }
    }
    return sum;
  }
  double mass() const {
    return of([](double, double) { return 1.0; });
  }
  /// int_{v<0} |v|^power p(0, v) dv.
  double impact_flux(int power) const {
    double sum = 0;
    for (std::size_t j = 0; j < weight_v_.size(); ++j) {
      const double v = points_.v()[j];
      if (v < 0) sum += weight_v_[j] * std::pow(-v, power) * value(0, j);
    }
    return sum;
  }
  transform::GridDensity averages() const {
    transform::GridDensity grid{points_.y_edges(), points_.v_edges(), {}};
    for (std::size_t i = 0; i < grid.ny(); ++i) {
      for (std::size_t j = 0; j < grid.nv(); ++j) {
        double sum = 0;
        for (std::size_t a = 0; a < kPointsOfACell; ++a) {
          for (std::size_t b = 0; b < kPointsOfACell; ++b) {
            sum +=
                kShares[a] * kShares[b] * value(1 + kPointsOfACell * i + a, kPointsOfACell * j + b);
          }
        }
        grid.averages.push_back(sum);
      }
    }
    return grid;
  }

 private:
  double value(std::size_t i, std::size_t j) const { return values_[i * weight_v_.size() + j]; }

  const DensityPoints& points_;
  const std::vector<double>& values_;
  std::vector<double> weight_y_, weight_v_;
};

Moments moments_of(const Integrals& integrals, double mass) {
  const auto mean = [&](const auto& g) { return integrals.of(g) / mass; };
  return {.y1 = mean([](double y, double) { return y; }),
          .y2 = mean([](double y, double) { return y * y; }),
          .y4 = mean([](double y, double) { return y * y * y * y; }),
          .v1 = mean([](double, double v) { return v; }),
          .v2 = mean([](double, double v) { return v * v; }),
          .v4 = mean([](double, double v) { return v * v * v * v; })};
}

// The largest average on the edges at which the cells end.
double at_the_end(const transform::GridDensity& grid) {
  double most = 0;
  for (std::size_t i = 0; i < grid.ny(); ++i) {
    most = std::max({most, grid.average(i, 0), grid.average(i, grid.nv() - 1)});
  }
  for (std::size_t j = 0; j < grid.nv(); ++j) most = std::max(most, grid.average(grid.ny() - 1, j));
  return most;
}

// Why the function is no density; empty where it is one.
std::string objection(const transform::GridDensity& grid, double peak, double least, double mass) {
  if (least < -kNegative * peak) {
    return fmt::format("it is negative, down to {:.1e} of its peak", least / peak);
  }
  const double end = at_the_end(grid);
  if (end > kCutOff * peak) {
    return fmt::format(
        "it is {:.1e} of its peak (allowed {:.0e}) where it is cut off, at y = {:.3g} and |y'| = "
        "{:.3g}",
        end / peak, kCutOff, grid.y_edges.back(), grid.v_edges.back());
  }
  if (std::abs(mass - 1) > kOffOne) return fmt::format("its integral is {:.6g} and not 1", mass);
  return {};
}

transform::BalanceResiduals balance_residuals(const problem::Problem& problem,
                                              const Integrals& integrals, const Moments& moments,
                                              double mass) {
  const auto& force = problem.system.force();
  const auto mean = [&](const problem::Polynomial& g) {
    return integrals.of([&](double y, double) { return g(y); }) / mass;
  };
  return {.virial = problem::virial_balance(problem, {.mean_displacement = moments.y1,
                                                      .mean_square_velocity = moments.v2,
                                                      .mean_virial = mean(force.times_argument())})
                        .residual(),
          .momentum = problem::momentum_balance(
                          problem, {.mean_force = mean(force),
                                    .impact_momentum = integrals.impact_flux(2) / mass})
                          .residual()};
}

void state_error(const ProblemResiduals& residuals, double accuracy, Solution& solution) {
  const bool was_ok = solution.is_ok();
  state_measured_error(residuals, accuracy, solution);
  if (!was_ok || solution.is_ok() || !solution.error) return;
  // Whether it meets any equation nobody has asked.
  solution.reason = fmt::format(
      "it misses the density of the problem by L1 {:.2g} in p(y) and {:.2g} in p(y') as measured "
      "by its residuals ({:g} is asked for: accuracy)",
      solution.error->y_l1, solution.error->ydot_l1, accuracy);
}

Solution solution_of(const problem::Problem& problem, const Setting& setting, const OwnDensity& own,
                     const OwnFunction& how, const DensityPoints& points,
                     const std::vector<double>& values, double divided_by) {
  const Integrals integrals(points, values);
  const auto [least, peak] = std::ranges::minmax(values);
  Solution solution;
  auto grid = integrals.averages();
  solution.mass = integrals.mass();
  solution.min_density = least / peak;
  solution.moments = moments_of(integrals, solution.mass);
  const auto& moments = solution.moments;
  solution.energy_residual =
      problem::energy_residual(problem, own.impact,
                               {.mean_velocity = moments.v1,
                                .mean_square_velocity = moments.v2,
                                .impact_energy_flux = integrals.impact_flux(3) / solution.mass});
  solution.reason = objection(grid, peak, least, solution.mass);
  solution.status = solution.reason.empty() ? Status::ok : Status::inadmissible;
  solution.density = std::move(grid);

  transform::Observer observer;
  if (how.normalise) observer.result("normalised_by", divided_by);
  observe(observer, balance_residuals(problem, integrals, moments, solution.mass));
  solution.observations = observer.take();
  if (own.equation && setting.residuals != nullptr) {
    state_error(*setting.residuals, how.accuracy, solution);
  }
  return solution;
}

transform::Identity identity_of(const OwnDensity& own, const std::string& what) {
  transform::Identity identity{.id = own.label,
                               .method = "given",
                               .role = transform::Role::given,
                               .family = "given",
                               .trust = static_cast<int>(own.place),
                               .look = given_look(own.place)};
  if (own.equation) {
    identity.role = transform::Role::closure;
    identity.equation = own.equation;
    identity.impact = own.impact;
    identity.meaning = fmt::format("A density of one's own, {}.", what);
  } else {
    identity.meaning = fmt::format(
        "A density of one's own, {}: neither its equation nor its impact is known.", what);
  }
  return identity;
}

// What is kept of samples.
struct Samples {
  std::vector<double> y, v;
  double independent;

  std::size_t size() const { return y.size(); }
};

std::optional<std::size_t> bin_of(const std::vector<double>& edges, double value) {
  if (!(value >= edges.front() && value < edges.back())) return std::nullopt;
  return static_cast<std::size_t>(std::ranges::upper_bound(edges, value) - edges.begin()) - 1;
}

// Shares of the samples, and their errors.
void put_marginal(const std::vector<double>& edges, const std::vector<double>& values,
                  double independent, Variable variable, Solution& solution) {
  const double n = static_cast<double>(values.size());
  std::vector<double> shares(edges.size() - 1);
  for (const double value : values) {
    if (const auto bin = bin_of(edges, value)) shares[*bin] += 1 / n;
  }
  transform::Marginal marginal{edges, {}, {}, {}};
  std::vector<BinError> errors;
  for (std::size_t b = 0; b < shares.size(); ++b) {
    const double width = edges[b + 1] - edges[b], density = shares[b] / width;
    const double error = std::sqrt(shares[b] * (1 - shares[b]) / independent) / width;
    marginal.density.push_back(density);
    marginal.lower.push_back(std::max(0.0, density - 1.96 * error));
    marginal.upper.push_back(density + 1.96 * error);
    errors.push_back({width, b, {error}});
  }
  const auto [expected, in_99] = sampling_l1(errors);
  auto& sampling = solution.sampling ? *solution.sampling : solution.sampling.emplace();
  (variable == Variable::y ? sampling.y : sampling.ydot) = expected;
  (variable == Variable::y ? sampling.y_99 : sampling.ydot_99) = in_99;
  solution.estimated_marginals.emplace_back(variable, std::move(marginal));
}

// Means of powers, and their standard errors.
void put_moments(const Samples& samples, Solution& solution) {
  constexpr int kPowers[] = {1, 2, 4, 1, 2, 4};  // of y, then of y'
  static_assert(std::size(kPowers) == std::size(transform::kMoments));
  const double n = static_cast<double>(samples.size());
  for (std::size_t k = 0; k < std::size(kPowers); ++k) {
    const auto moment = transform::kMoments[k].moment;
    const auto& values = k < 3 ? samples.y : samples.v;
    double sum = 0, squares = 0;
    for (const double value : values) sum += std::pow(value, kPowers[k]);
    const double mean = sum / n;
    for (const double value : values) squares += std::pow(std::pow(value, kPowers[k]) - mean, 2);
    solution.moments.*moment = mean;
    solution.standard_errors->moments.*moment = std::sqrt(squares / n / samples.independent);
  }
}

Solution solution_of(const Samples& samples, const compare::ComparisonAxes& axes) {
  Solution solution;
  solution.status = Status::ok;
  solution.energy_residual = kNotKnown;
  solution.standard_errors.emplace().energy_residual = kNotKnown;
  transform::GridDensity grid{axes.y_edges, axes.v_edges, {}};
  grid.averages.assign(grid.ny() * grid.nv(), 0.0);
  const double each = 1 / static_cast<double>(samples.size());
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const auto i = bin_of(grid.y_edges, samples.y[k]), j = bin_of(grid.v_edges, samples.v[k]);
    if (!i || !j) continue;
    solution.mass += each;
    grid.averages[*i * grid.nv() + *j] += each / ((grid.y_edges[*i + 1] - grid.y_edges[*i]) *
                                                  (grid.v_edges[*j + 1] - grid.v_edges[*j]));
  }
  solution.density = std::move(grid);
  put_marginal(axes.y_edges, samples.y, samples.independent, Variable::y, solution);
  put_marginal(axes.v_edges, samples.v, samples.independent, Variable::ydot, solution);
  put_moments(samples, solution);
  solution.observations = transform::Observer()
                              .work("samples", transform::counted(samples.size()))
                              .work("independent", samples.independent)
                              .take();
  return solution;
}

}  // namespace

DensityPoints::DensityPoints(const compare::ComparisonAxes& axes)
    : y_edges_(extended(axes.y_edges)), y_{0} {
  const auto wall = std::ranges::find(axes.v_edges, 0.0);
  v_edges_ = mirrored(extended({wall, axes.v_edges.end()}));
  add_points(y_edges_, y_);
  add_points(v_edges_, v_);
}

Method own_function(const OwnDensity& own, const OwnFunction& how, const DensityPoints& points,
                    std::vector<double> values) {
  const std::size_t nv = points.v().size();
  if (values.size() != points.y().size() * nv) {
    throw InputError(fmt::format("density '{}': {} values (must be {} x {})", own.label,
                                 values.size(), points.y().size(), nv));
  }
  const auto bad = std::ranges::find_if(values, [](double p) { return !std::isfinite(p); });
  if (bad != values.end()) {
    const auto k = static_cast<std::size_t>(bad - values.begin());
    throw InputError(fmt::format("density '{}': p({:.4g}, {:.4g}) is {} (must be a finite number)",
                                 own.label, points.y()[k / nv], points.v()[k % nv], *bad));
  }
  const double mass = Integrals(points, values).mass();
  if (!(mass > 0) || !std::isfinite(mass)) {
    throw InputError(
        fmt::format("density '{}': its integral is {:.4g} (must be positive)", own.label, mass));
  }
  if (how.normalise) {
    for (double& value : values) value /= mass;
  }
  return {.identity = identity_of(own, "given as a function"),
          .solve = [own, how, points, mass, values = std::move(values)](
                       const problem::Problem& problem, const Setting& setting) {
            return solution_of(problem, setting, own, how, points, values, mass);
          }};
}

Method own_samples(const OwnDensity& own, std::span<const double> y, std::span<const double> v,
                   double independent) {
  constexpr std::size_t kFewest = 100;
  const auto refuse = [&own](const std::string& why) {
    throw InputError(fmt::format("samples '{}': {}", own.label, why));
  };
  if (y.size() != v.size()) refuse(fmt::format("{} of y and {} of y'", y.size(), v.size()));
  if (y.size() < kFewest) refuse(fmt::format("{} (must be {} at least)", y.size(), kFewest));
  for (std::size_t k = 0; k < y.size(); ++k) {
    if (!std::isfinite(y[k]) || !std::isfinite(v[k]) || y[k] < 0) {
      refuse(fmt::format("y = {:.4g}, y' = {:.4g} (must be finite, and y >= 0)", y[k], v[k]));
    }
  }
  const auto all = static_cast<double>(y.size());
  if (!(independent >= 0 && independent <= all)) {
    refuse(
        fmt::format("independent = {:g} (must be 0 .. {}, their number)", independent, y.size()));
  }
  return {.identity = identity_of(own, "given as samples"),
          .solve = [samples = Samples{{y.begin(), y.end()},
                                      {v.begin(), v.end()},
                                      independent > 0 ? independent : all}](
                       const problem::Problem&, const Setting& setting) {
            return solution_of(samples, setting.axes);
          }};
}

}  // namespace fpkcheck::methods
