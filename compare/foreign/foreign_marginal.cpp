#include "compare/foreign/foreign_marginal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/fpclassify.hpp>
#include <cmath>
#include <fstream>
#include <numbers>

#include "problem/input_error.hpp"

// After fpclassify: pchip of Boost 1.74 calls isnan without having declared it.
#include <boost/math/interpolators/makima.hpp>
#include <boost/math/interpolators/pchip.hpp>

namespace fpkcheck::compare {
namespace {

using transform::Variable;

bool any_of(const NumberTable& table, std::initializer_list<std::string_view> known) {
  return std::ranges::any_of(table.names, [&](const std::string& name) {
    return std::ranges::find(known, name) != known.end();
  });
}

Variable variable_of(const NumberTable& table) {
  const bool velocity = any_of(table, {"ydot", "y'", "v", "velocity", "dy/dt", "xdot", "x'",
                                       "p(ydot)", "p(y')", "p(v)", "p_ydot", "p_v"});
  const bool displacement = any_of(table, {"y", "x", "displacement", "p(y)", "p_y", "p(x)"});
  if (velocity != displacement) return velocity ? Variable::ydot : Variable::y;
  return std::ranges::any_of(table.rows, [](const auto& row) { return row.front() < 0; })
             ? Variable::ydot
             : Variable::y;
}

// Edges are often sums of widths, and off by a rounding.
bool join(const std::vector<double>& bin, const std::vector<double>& next) {
  constexpr double kRounding = 1e-6;
  return std::abs(next[0] - bin[1]) <= kRounding * std::abs(bin[1] - bin[0]);
}

bool is_histogram(const NumberTable& table) {
  if (table.columns() != 3) return false;
  if (any_of(table, {"lower", "upper", "left", "right", "from", "to", "count", "counts"})) {
    return true;
  }
  for (std::size_t k = 1; k < table.rows.size(); ++k) {
    if (!join(table.rows[k - 1], table.rows[k])) return false;
  }
  return true;
}

// Counts are whole and do not integrate to 1.
bool are_counts(const NumberTable& table, double integral) {
  if (any_of(table, {"count", "counts", "frequency", "n"})) return true;
  return integral > 2 && std::ranges::all_of(table.rows, [](const auto& row) {
           return row.back() == std::floor(row.back());
         });
}

void require_rows(const NumberTable& table, Variable variable) {
  constexpr std::size_t kFewest = 4;  // of the interpolants
  const std::size_t last = table.rows.size() - 1;
  if (table.rows.size() < kFewest) {
    table.fail(last, fmt::format("{} rows (must be at least {})", last + 1, kFewest));
  }
  for (std::size_t k = 0; k <= last; ++k) {
    const double x = table.rows[k][0];
    if (k > 0 && x <= table.rows[k - 1][0]) {
      table.fail(k, fmt::format("{:g} after {:g} (must increase)", x, table.rows[k - 1][0]));
    }
    if (variable == Variable::y && x < 0) {
      table.fail(k, fmt::format("y = {:g} (must not be negative)", x));
    }
  }
}

void require_not_negative(const NumberTable& table, std::size_t column, const char* what) {
  for (std::size_t k = 0; k < table.rows.size(); ++k) {
    if (table.rows[k][column] < 0) {
      table.fail(k, fmt::format("{} {:g} (must not be negative)", what, table.rows[k][column]));
    }
  }
}

template <class Function>
double integral(const Function& f, double a, double b) {
  return boost::math::quadrature::gauss<double, 7>::integrate(f, a, b);
}

}  // namespace

ForeignMarginal::ForeignMarginal(const NumberTable& table) : variable_(variable_of(table)) {
  require_rows(table, variable_);
  const bool histogram = is_histogram(table);
  description_ = {{"file", table.source},
                  {"variable", transform::name(variable_)},
                  {"form", histogram ? "histogram" : "points"},
                  {"rows", table.rows.size()}};
  histogram ? read_histogram(table) : read_points(table);
}

void ForeignMarginal::read_histogram(const NumberTable& table) {
  require_not_negative(table, 2, "density or count");
  knots_ = {table.rows.front()[0]};
  for (std::size_t k = 0; k < table.rows.size(); ++k) {
    const double lower = table.rows[k][0], upper = table.rows[k][1];
    if (k > 0 && !join(table.rows[k - 1], table.rows[k])) {
      table.fail(k, fmt::format("a bin from {:g} after one to {:g} (bins must join)", lower,
                                knots_.back()));
    }
    if (upper <= lower) {
      table.fail(k, fmt::format("a bin from {:g} to {:g} (edges must increase)", lower, upper));
    }
    knots_.push_back(upper);
  }
  double as_density = 0;
  for (const auto& row : table.rows) as_density += row[2] * (row[1] - row[0]);
  const bool counts = are_counts(table, as_density);
  cumulative_ = {0};
  for (const auto& row : table.rows) {
    cumulative_.push_back(cumulative_.back() + row[2] * (counts ? 1 : row[1] - row[0]));
  }
  using Monotone = boost::math::interpolators::pchip<std::vector<double>>;
  auto x = knots_, below = cumulative_;
  density_ = [cubic = Monotone(std::move(x), std::move(below))](double at) {
    return cubic.prime(at);
  };
  normalise(counts);
}

void ForeignMarginal::read_points(const NumberTable& table) {
  require_not_negative(table, 1, "density");
  knots_ = table.column(0);
  auto values = table.column(1);
  if (table.columns() == 3) {
    require_not_negative(table, 2, "standard error");
    errors_ = table.column(2);
  }
  const double first = knots_[0], spacing = knots_[1] - knots_[0];
  if (variable_ == Variable::y && first > 0 && first <= spacing) {
    const double at_wall = values[0] - (values[1] - values[0]) / spacing * first;
    knots_.insert(knots_.begin(), 0);
    values.insert(values.begin(), std::max(at_wall, 0.0));
    if (has_errors()) errors_.insert(errors_.begin(), errors_.front());
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
  normalise(false);
}

void ForeignMarginal::normalise(bool counts) {
  constexpr double kNearOne = 0.1;
  const double total = cumulative_.back();
  const std::string file = description_.at("file").get<std::string>();
  if (!(total > 0)) throw InputError(fmt::format("{}: the density is 0 everywhere", file));
  description_["from"] = knots_.front();
  description_["to"] = knots_.back();
  description_["integral"] = total;
  description_["notes"] = nlohmann::ordered_json::array();
  if (counts || std::abs(total - 1) > kNearOne) {
    scale_ = 1 / total;
    description_["normalised_by"] = total;
    description_["notes"].push_back(
        counts ? fmt::format("its counts were divided by their sum, {:g}", total)
               : fmt::format("it was divided by its integral, {:.4g}", total));
  }
  note_cut_ends();
}

void ForeignMarginal::note_cut_ends() {
  constexpr double kSmall = 1e-3;  // of the peak
  double peak = 0;
  for (std::size_t k = 1; k < knots_.size(); ++k) {
    peak = std::max(peak, (cumulative_[k] - cumulative_[k - 1]) / (knots_[k] - knots_[k - 1]));
  }
  const auto note = [&](double end) {
    const double share = density_(end) / peak;
    if (share <= kSmall) return;
    description_["notes"].push_back(
        fmt::format("its {} ends at {:.4g} with {:.2g} of its peak, and beyond it counts as 0",
                    variable_ == Variable::y ? "p(y)" : "p(y')", end, share));
  };
  if (variable_ == Variable::ydot || knots_.front() > 0) note(knots_.front());
  note(knots_.back());
}

double ForeignMarginal::cumulative(double x) const {
  if (x <= knots_.front()) return 0;
  if (x >= knots_.back()) return cumulative_.back();
  const auto k = std::ranges::upper_bound(knots_, x) - knots_.begin() - 1;
  if (x == knots_[k]) return cumulative_[k];
  return cumulative_[k] + integral(density_, knots_[k], x);
}

transform::Marginal ForeignMarginal::on(std::span<const double> edges) const {
  transform::Marginal result{{edges.begin(), edges.end()}, {}, {}, {}};
  double below = cumulative(edges.front());
  for (std::size_t b = 0; b + 1 < edges.size(); ++b) {
    const double upper = cumulative(edges[b + 1]);
    result.density.push_back(std::max(scale_ * (upper - below) / result.width(b), 0.0));
    below = upper;
    if (!has_errors()) continue;

    // The error of the interpolant's average is nearly that of the points it lies between.
    constexpr double kTwoSided95 = 1.959964;
    const double centre = result.centre(b);
    double error = 0;
    if (centre >= knots_.front() && centre <= knots_.back()) {
      const auto last = std::ssize(knots_) - 1;
      const auto k = std::clamp<std::ptrdiff_t>(
          std::ranges::upper_bound(knots_, centre) - knots_.begin(), 1, last);
      error = std::lerp(errors_[k - 1], errors_[k],
                        (centre - knots_[k - 1]) / (knots_[k] - knots_[k - 1]));
    }
    const double half = kTwoSided95 * scale_ * error;
    result.lower.push_back(std::max(result.density.back() - half, 0.0));
    result.upper.push_back(result.density.back() + half);
  }
  return result;
}

double ForeignMarginal::moment(int power) const {
  double sum = 0;
  for (std::size_t k = 1; k < knots_.size(); ++k) {
    sum += integral([&](double x) { return std::pow(x, power) * density_(x); }, knots_[k - 1],
                    knots_[k]);
  }
  return scale_ * sum;
}

double ForeignMarginal::expected_l1() const {
  double sum = 0;  // by trapezoids; E|e| = sqrt(2/pi) sigma
  for (std::size_t k = 1; k < errors_.size(); ++k) {
    sum += (errors_[k - 1] + errors_[k]) / 2 * (knots_[k] - knots_[k - 1]);
  }
  return scale_ * sum * std::sqrt(2 / std::numbers::pi);
}

ForeignMarginal read_foreign_marginal(const std::filesystem::path& file) {
  std::error_code ignored;
  std::ifstream in;
  if (std::filesystem::is_regular_file(file, ignored)) in.open(file);
  if (!in.is_open()) {
    throw InputError(fmt::format("--against: '{}' is not a readable file", file.string()));
  }
  return ForeignMarginal(read_number_table(in, file.string()));
}

}  // namespace fpkcheck::compare
