#include "mcs/deposit/sample_deposit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "base/input_error.hpp"

namespace fpkcheck::mcs {
namespace {

constexpr int kDegree = SampleDepositionGrid::kDegree;
constexpr int kEight = SplineSpanPolynomials::kWidth;
constexpr double kMostCells = 1e5;

void require_deposit_condition(bool holds, const std::string& message) {
  if (!holds) throw InputError("mcs.deposit: " + message);
}

std::vector<double> distinct_knot_values(const std::vector<double>& knots) {
  std::vector<double> breaks(knots);
  breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
  return breaks;
}

double shortest_span(const std::vector<double>& breaks) {
  double least = breaks[1] - breaks[0];
  for (std::size_t k = 1; k + 1 < breaks.size(); ++k) {
    least = std::min(least, breaks[k + 1] - breaks[k]);
  }
  return least;
}

void require_knots(const std::string& name, const std::vector<double>& knots) {
  const auto repeated = [&](double x) { return std::ranges::count(knots, x); };
  require_deposit_condition(
      knots.size() > 2 * kDegree + 2 && std::ranges::is_sorted(knots) &&
          std::isfinite(knots.front()) && std::isfinite(knots.back()) &&
          knots.front() < knots.back() && repeated(knots.front()) == kDegree + 1 &&
          repeated(knots.back()) == kDegree + 1,
      fmt::format("{1} knots of {0}: must be sorted, with ends of multiplicity six", name,
                  knots.size()));
  const std::vector<double> breaks = distinct_knot_values(knots);
  for (std::size_t k = 1; k + 1 < breaks.size(); ++k) {
    require_deposit_condition(
        repeated(breaks[k]) <= kDegree,
        fmt::format("knots of {}: an inner knot has a multiplicity above five", name));
  }
  require_deposit_condition(shortest_span(breaks) * kMostCells > breaks.back() - breaks.front(),
                            fmt::format("knots of {}: too close together", name));
}

void require_bins(const std::string& name, const SmoothBins& bins) {
  require_deposit_condition(
      bins.count >= 1 && bins.spacing > 0 && std::isfinite(bins.first) &&
          std::isfinite(bins.spacing),
      fmt::format("{} smooth bins of {} with spacing {}: both must be positive", bins.count, name,
                  bins.spacing));
}

using Coefficients = std::vector<double>;  // polynomial coefficients of 1, t, t^2, ..

/// Returns the polynomial a p(t) + (b + c t) q(t) of two polynomials p and q.
Coefficients combine_polynomials(double a, const Coefficients& p, double b, double c,
                                 const Coefficients& q) {
  Coefficients sum(std::max(p.size(), q.size() + 1), 0.0);
  for (std::size_t n = 0; n < p.size(); ++n) sum[n] += a * p[n];
  for (std::size_t n = 0; n < q.size(); ++n) {
    sum[n] += b * q[n];
    sum[n + 1] += c * q[n];
  }
  return sum;
}

/// Returns the six splines that are nonzero on a knot span, as polynomials of t = (x -
/// begin)/width, shape (6, 6), by the recursion of Cox and de Boor.
/// @param last_knot index of the last knot among the knots that coincide at the beginning of the
/// span
std::vector<Coefficients> span_splines(const std::vector<double>& knots, std::size_t last_knot) {
  const double begin = knots[last_knot], width = knots[last_knot + 1] - begin;
  std::vector<Coefficients> functions{{1.0}};
  for (int p = 1; p <= kDegree; ++p) {
    std::vector<Coefficients> next(functions.size() + 1, Coefficients{0.0});
    for (std::size_t l = 0; l < functions.size(); ++l) {
      const std::size_t i = last_knot - static_cast<std::size_t>(p - 1) + l;
      const double low = knots[i], length = knots[i + static_cast<std::size_t>(p)] - low;
      const double at = (begin - low) / length, slope = width / length;
      next[l + 1] = combine_polynomials(1, next[l + 1], at, slope, functions[l]);
      next[l] = combine_polynomials(1, next[l], 1 - at, -slope, functions[l]);
    }
    functions = std::move(next);
  }
  for (Coefficients& f : functions) f.resize(kDegree + 1);
  return functions;
}

/// Appends polynomial coefficients to a table, from the highest power to the constant term. Each
/// row of the table has the coefficients of one power of t for all polynomials of a knot span.
void append_coefficient_rows(std::vector<double>& table, const std::vector<Coefficients>& functions,
                             int highest) {
  for (int n = highest; n >= 0; --n) {
    for (int l = 0; l < kEight; ++l) {
      const bool there = l < static_cast<int>(functions.size());
      table.push_back(there ? functions[static_cast<std::size_t>(l)][static_cast<std::size_t>(n)]
                            : 0.0);
    }
  }
}

Coefficients multiply_by_linear(const Coefficients& p, double constant, double slope) {
  return combine_polynomials(0, {}, constant, slope, p);
}

std::vector<double> lagrange_polynomials() {
  std::vector<Coefficients> polynomials;
  for (int q = -3; q <= 4; ++q) {
    Coefficients polynomial{1.0};
    for (int p = -3; p <= 4; ++p) {
      if (p != q) polynomial = multiply_by_linear(polynomial, -p / double(q - p), 1.0 / (q - p));
    }
    polynomials.push_back(std::move(polynomial));
  }
  std::vector<double> table;
  append_coefficient_rows(table, polynomials, SampleDepositionGrid::kStencil - 1);
  return table;
}

std::vector<double> cubic_pieces() {
  // Coefficients of the cubic B-splines M(t + 1), M(t), M(t - 1), M(t - 2) on 0 <= t <= 1.
  std::vector<double> table;
  append_coefficient_rows(table,
                          {{1. / 6, -1. / 2, 1. / 2, -1. / 6},
                           {4. / 6, 0, -1, 1. / 2},
                           {1. / 6, 1. / 2, 1. / 2, -1. / 2},
                           {0, 0, 0, 1. / 6}},
                          3);
  return table;
}

}  // namespace

void require_valid_deposit_grid(const SampleDepositionGrid& grid) {
  require_knots("y", grid.y_knots);
  require_knots("v", grid.v_knots);
  require_deposit_condition(grid.y_knots.front() == 0, "the knots of y must begin at 0");
  require_deposit_condition(
      grid.lattice_points >= SampleDepositionGrid::kStencil && grid.lattice_spacing > 0 &&
          std::isfinite(grid.lattice_begin),
      fmt::format("{} lattice points: use at least {}, a finite begin and a positive spacing",
                  grid.lattice_points, SampleDepositionGrid::kStencil));
  require_bins("y", grid.y_bins);
  require_bins("v", grid.v_bins);
}

SplineSpanPolynomials::SplineSpanPolynomials(const std::vector<double>& knots)
    : begin_(knots.front()), end_(knots.back()) {
  for (std::size_t k = kDegree; k + kDegree + 1 < knots.size(); ++k) {
    if (knots[k] == knots[k + 1]) continue;
    const auto functions = span_splines(knots, k);
    const double width = knots[k + 1] - knots[k];
    std::vector<Coefficients> slopes;
    for (const Coefficients& f : functions) {
      Coefficients slope;
      for (int n = 1; n <= kDegree; ++n)
        slope.push_back(n * f[static_cast<std::size_t>(n)] / width);
      slopes.push_back(slope);
    }
    std::vector<double> table;
    append_coefficient_rows(table, functions, kDegree);
    append_coefficient_rows(table, slopes, kDegree - 1);
    // Knot spans whose spline coefficients agree up to rounding share one coefficient table.
    int place = 0;
    const auto has_same_coefficients = [&](int from) {
      return std::equal(table.begin(), table.end(), coefficients_.begin() + from,
                        [&](double a, double b) { return std::abs(a - b) <= 1e-12 / width; });
    };
    const int stored = static_cast<int>(coefficients_.size());
    while (place < stored && !has_same_coefficients(place)) place += static_cast<int>(table.size());
    if (place == stored) coefficients_.insert(coefficients_.end(), table.begin(), table.end());
    first_.push_back(static_cast<int>(k) - kDegree);
    place_.push_back(place);
    breaks_.push_back(knots[k]);
    per_length_.push_back(1 / width);
  }
  breaks_.push_back(end_);
  const auto cells = static_cast<int>(std::ceil((end_ - begin_) / shortest_span(breaks_)));
  cells_per_length_ = cells / (end_ - begin_);
  for (int cell = 0, span = 0; cell < cells; ++cell) {
    const double from = begin_ + cell / cells_per_length_;
    while (span + 1 < break_span_count() && breaks_[static_cast<std::size_t>(span) + 1] <= from)
      ++span;
    span_of_cell_.push_back(span);
  }
}

SampleDepositionPlan::SampleDepositionPlan(const SampleDepositionGrid& g, double lambda,
                                           double interval)
    : grid((require_valid_deposit_grid(g), g)),
      y(g.y_knots),
      v(g.v_knots),
      rate(lambda),
      sampling_interval(interval),
      lagrange(lagrange_polynomials()),
      cubics(cubic_pieces()) {}

}  // namespace fpkcheck::mcs
