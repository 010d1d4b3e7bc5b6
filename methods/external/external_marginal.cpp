#include "methods/external/external_marginal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/fpclassify.hpp>
#include <cassert>
#include <cmath>

#include "base/input_error.hpp"
#include "base/text/printable_text.hpp"
#include "methods/external/bin_average_errors.hpp"
#include "methods/external/number_table.hpp"
#include "numerics/statistics.hpp"

// pchip.hpp follows fpclassify, since pchip of Boost 1.74 calls isnan without a declaration.
#include <boost/math/interpolators/makima.hpp>
#include <boost/math/interpolators/pchip.hpp>

namespace fpkcheck::methods {
namespace {

using transform::StateVariable;

void require_range_between_walls(const NumberTable& table, std::size_t row, double y,
                                 const problem::Walls& walls) {
  if (is_between_walls(walls, y)) return;
  // Two causes of a value behind a wall are likely: the column names select the variable y by
  // mistake, or the density file belongs to another case.
  table.throw_row_error(
      row, fmt::format("y = {:g} under the names {} (must be {}; name the abscissa 'v' for a "
                       "density of y')",
                       y, base::in_quotes(fmt::format("{}", fmt::join(table.names, ","))),
                       admissible_range_text(walls)));
}

void require_rows(const NumberTable& table, const problem::Walls& walls) {
  constexpr std::size_t kMinRows = 4;  // the interpolants need four points
  const std::size_t last = table.rows.size() - 1;
  if (table.rows.size() < kMinRows) {
    table.throw_row_error(last, fmt::format("{} rows (must be at least {})", last + 1, kMinRows));
  }
  for (std::size_t k = 0; k <= last; ++k) {
    const double x = table.rows[k][0];
    if (k > 0 && x <= table.rows[k - 1][0]) {
      table.throw_row_error(
          k, fmt::format("{} after {} (must increase{})", x, table.rows[k - 1][0],
                         table.column_count() == 3 ? "; name a joint density y,v,p" : ""));
    }
    require_range_between_walls(table, k, x, walls);
  }
}

void require_not_negative(const NumberTable& table, std::size_t column, const char* what) {
  for (std::size_t k = 0; k < table.rows.size(); ++k) {
    if (table.rows[k][column] < 0) {
      table.throw_row_error(
          k, fmt::format("{} {:g} (must not be negative)", what, table.rows[k][column]));
    }
  }
}

template <class Function>
double integral(const Function& f, double a, double b) {
  return boost::math::quadrature::gauss<double, 7>::integrate(f, a, b);
}

}  // namespace

ExternalMarginal::ExternalMarginal(const NumberTable& table, const problem::Walls& walls)
    : variable_(variable_from_column_names(table)),
      walls_(variable_ == StateVariable::y ? walls : problem::Walls{}) {
  require_rows(table, walls_);
  const bool histogram = is_histogram(table);
  file_.path = table.source;
  file_.form = histogram ? "histogram" : "points";
  file_.rows = table.rows.size();
  histogram ? read_histogram(table) : read_points(table);
}

void ExternalMarginal::read_histogram(const NumberTable& table) {
  require_not_negative(table, 2, "density or count");
  knots_ = {table.rows.front()[0]};
  for (std::size_t k = 0; k < table.rows.size(); ++k) {
    const double lower = table.rows[k][0], upper = table.rows[k][1];
    if (upper <= lower) {
      table.throw_row_error(
          k, fmt::format("a bin from {:g} to {:g} (edges must increase)", lower, upper));
    }
    if (k > 0 && !are_bins_adjacent(table.rows[k - 1], table.rows[k])) {
      table.throw_row_error(k, fmt::format("a bin from {:g} after a bin to {:g} (bins must adjoin)",
                                           lower, knots_.back()));
    }
    require_range_between_walls(table, k, upper, walls_);
    knots_.push_back(upper);
  }
  const HistogramQuantity value = detect_histogram_quantity(table);
  file_.values = name(value);
  cumulative_ = {0};
  for (const auto& row : table.rows) {
    cumulative_.push_back(cumulative_.back() +
                          row[2] * (value == HistogramQuantity::density ? row[1] - row[0] : 1));
  }
  using Monotone = boost::math::interpolators::pchip<std::vector<double>>;
  auto x = knots_, below = cumulative_;
  density_ = [cubic = Monotone(std::move(x), std::move(below))](double at) {
    return cubic.prime(at);
  };
  normalise(value);
}

void ExternalMarginal::read_points(const NumberTable& table) {
  require_not_negative(table, 1, "density");
  knots_ = table.column_values(0);
  auto values = table.column_values(1);
  if (table.column_count() == 3) {
    require_not_negative(table, 2, "standard error");
    errors_ = table.column_values(2);
  }
  extrapolation_ = select_extrapolation_walls(walls_, knots_);
  const std::size_t before_last = knots_.size() - 2;
  if (extrapolation_.right) {
    const double wall = walls_.right->position;
    values.push_back(extrapolate_to_wall(wall, knots_, values, before_last, 0));
    knots_.push_back(wall);
  }
  if (extrapolation_.left) {
    const double wall = walls_.left->position;
    values.insert(values.begin(), extrapolate_to_wall(wall, knots_, values, 0, 0));
    knots_.insert(knots_.begin(), wall);
  }
  using Akima = boost::math::interpolators::makima<std::vector<double>>;
  auto x = knots_;
  density_ = [cubic = Akima(std::move(x), std::move(values))](double at) {
    return std::max(cubic(at), 0.0);
  };
  cumulative_ = {0};
  for (std::size_t k = 1; k < knots_.size(); ++k) {
    cumulative_.push_back(cumulative_.back() + integral(density_, knots_[k - 1], knots_[k]));
  }
  normalise(HistogramQuantity::density);
}

void ExternalMarginal::normalise(HistogramQuantity value) {
  constexpr double kNearOne = 0.1;
  const double total = cumulative_.back();
  const std::string file = base::to_printable_text(file_.path);
  if (!(total > 0)) throw InputError(fmt::format("{}: the density is 0 everywhere", file));
  if (!std::isfinite(total)) {
    throw InputError(fmt::format("{}: the integral overflows; choose other units", file));
  }
  // Derivatives and moments of a marginal density may overflow, even if the abscissae are finite.
  const auto overflows = [](double x) { return !std::isfinite(x) || std::abs(x) > kMaxMagnitude; };
  if (overflows(total) || overflows(knots_.front()) || overflows(knots_.back()) ||
      !std::isfinite(density_(knots_.front())) || !std::isfinite(density_(knots_.back()))) {
    throw InputError(fmt::format("{}: the numbers are too large; choose other units", file));
  }
  file_.from = knots_.front();
  file_.to = knots_.back();
  file_.integral = total;
  if (value == HistogramQuantity::probability) {
    file_.notes.emplace_back("the probabilities per bin were divided by the bin widths");
  }
  if (value == HistogramQuantity::count || std::abs(total - 1) > kNearOne) {
    scale_ = 1 / total;
    file_.divided_by = total;
    file_.notes.push_back(
        value == HistogramQuantity::density
            ? fmt::format("the density was divided by its integral, {:.4g}", total)
            : fmt::format("the {} were divided by their sum, {:g}",
                          value == HistogramQuantity::count ? "counts" : "probabilities", total));
  }
  add_cut_off_notes();
}

void ExternalMarginal::add_cut_off_notes() {
  constexpr double kSmall = 1e-3;  // limit relative to the peak of the density
  double peak = 0;
  for (std::size_t k = 1; k < knots_.size(); ++k) {
    peak = std::max(peak, (cumulative_[k] - cumulative_[k - 1]) / (knots_[k] - knots_[k - 1]));
  }
  const auto note = [&](double end) {
    const double share = density_(end) / peak;
    if (share <= kSmall) return;
    file_.notes.push_back(
        fmt::format("{} is cut off at {:.4g}, at {:.2g} of its peak, and taken as 0 beyond",
                    variable_ == StateVariable::y ? "p(y)" : "p(y')", end, share));
  };
  if (!is_at_wall(walls_.left, knots_.front())) note(knots_.front());
  if (!is_at_wall(walls_.right, knots_.back())) note(knots_.back());
}

double ExternalMarginal::marginal_cumulative_probability(double x) const {
  if (x <= knots_.front()) return 0;
  if (x >= knots_.back()) return cumulative_.back();
  const auto k = std::ranges::upper_bound(knots_, x) - knots_.begin() - 1;
  if (x == knots_[k]) return cumulative_[k];
  return cumulative_[k] + integral(density_, knots_[k], x);
}

transform::Marginal ExternalMarginal::average_over_bins(std::span<const double> edges) const {
  transform::Marginal result{{edges.begin(), edges.end()}, {}, {}, {}};
  double below = marginal_cumulative_probability(edges.front());
  for (std::size_t b = 0; b + 1 < edges.size(); ++b) {
    const double upper = marginal_cumulative_probability(edges[b + 1]);
    result.density.push_back(std::max(scale_ * (upper - below) / result.bin_width(b), 0.0));
    below = upper;
  }
  if (!has_standard_errors()) return result;
  const auto errors = compute_bin_average_errors(knots_, errors_, edges, extrapolation_);
  for (std::size_t b = 0; b < result.size(); ++b) {
    const double half = numerics::kNormal95 * scale_ * errors[b].standard_error();
    result.lower.push_back(std::max(result.density[b] - half, 0.0));
    result.upper.push_back(result.density[b] + half);
  }
  return result;
}

double ExternalMarginal::mass_fraction_outside(double lower, double upper) const {
  return std::clamp(
      1 - (marginal_cumulative_probability(upper) - marginal_cumulative_probability(lower)) /
              cumulative_.back(),
      0.0, 1.0);
}

double ExternalMarginal::moment(int power) const {
  double sum = 0;
  for (std::size_t k = 1; k < knots_.size(); ++k) {
    sum += integral([&](double x) { return std::pow(x, power) * density_(x); }, knots_[k - 1],
                    knots_[k]);
  }
  return scale_ * sum;
}

L1SamplingError ExternalMarginal::l1_sampling_error(std::span<const double> edges) const {
  assert(has_standard_errors());
  const auto [expected, quantile_99] = methods::l1_sampling_error(
      compute_bin_average_errors(knots_, errors_, edges, extrapolation_));
  return {scale_ * expected, scale_ * quantile_99};
}

}  // namespace fpkcheck::methods
