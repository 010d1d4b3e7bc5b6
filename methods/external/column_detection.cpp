#include "methods/external/number_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "base/text/printable_text.hpp"

namespace fpkcheck::methods {
namespace {

using transform::StateVariable;
using Names = std::span<const std::string_view>;

constexpr std::string_view kVelocity[] = {"ydot", "y'",      "v",     "velocity", "dy/dt",  "xdot",
                                          "x'",   "p(ydot)", "p(y')", "p(v)",     "p_ydot", "p_v"};
constexpr std::string_view kDisplacement[] = {"y", "x", "displacement", "p(y)", "p_y", "p(x)"};
// Names of the variables themselves, in files of joint densities and of samples.
constexpr std::string_view kTime[] = {"t", "time"};
constexpr std::string_view kPosition[] = {"y", "x", "displacement"};
constexpr std::string_view kSpeed[] = {"ydot", "y'", "v", "velocity", "dy/dt", "xdot", "x'"};
constexpr std::string_view kEdges[] = {"lower", "upper", "left", "right", "from", "to"};
constexpr std::string_view kCounts[] = {"count", "counts", "frequency", "samples", "n"};
constexpr std::string_view kProbabilities[] = {"probability", "probabilities"};
constexpr std::string_view kDensities[] = {"density", "pdf"};

bool is_one_of(const std::string& name, Names known) {
  return std::ranges::find(known, name) != known.end();
}

bool any_of(const std::vector<std::string>& names, Names known) {
  return std::ranges::any_of(names, [&](const auto& name) { return is_one_of(name, known); });
}

// Returns the names of the columns, with empty texts in place of ambiguous names. Many files name
// any ordinate "y" and any abscissa "x"; in such files the names identify no variable.
std::vector<std::string> without_ambiguous_names(std::vector<std::string> names) {
  if (names.size() < 2 || names[1] != "y") return names;
  names[1].clear();
  if (names[0] == "x") names[0].clear();
  return names;
}

bool is_near_one(double sum) {
  constexpr double kRounding = 1e-6;
  return std::abs(sum - 1) <= kRounding;
}

// Returns the gap between two bins relative to the width of the narrower bin. The gap is not
// divided by the width of the wider bin, since a narrow bin inside a wide bin would then count as
// contiguous. The edges of the bins are halved, since differences of halved numbers cannot
// overflow.
double relative_gap(const std::vector<double>& bin, const std::vector<double>& next) {
  const auto half_width = [](const auto& row) { return std::abs(row[1] / 2 - row[0] / 2); };
  return std::abs(next[0] / 2 - bin[1] / 2) / std::min(half_width(bin), half_width(next));
}

// Printed times are rounded, and their steps are unequal. A step that differs from the mean step by
// half of it shows a gap in the record.
void require_equidistant_times(const NumberTable& table, std::size_t column) {
  constexpr double kTolerance = 0.5;
  const auto time = [&](std::size_t k) { return table.rows[k][column]; };
  const std::size_t last = table.rows.size() - 1;
  const double mean_step =
      (time(last) - time(0)) / static_cast<double>(std::max<std::size_t>(last, 1));
  for (std::size_t k = 1; k <= last; ++k) {
    const double step = time(k) - time(k - 1);
    if (mean_step > 0 && std::abs(step - mean_step) <= kTolerance * mean_step) continue;
    table.throw_row_error(k,
                          fmt::format("the time advances by {:.6g}, on average by {:.6g} (must be "
                                      "equidistant and increasing); resample the record",
                                      step, mean_step));
  }
}

}  // namespace

StateVariable variable_from_column_names(const NumberTable& table) {
  const auto names = without_ambiguous_names(table.names);
  const bool velocity = any_of(names, kVelocity), displacement = any_of(names, kDisplacement);
  if (velocity != displacement) return velocity ? StateVariable::ydot : StateVariable::y;
  return std::ranges::any_of(table.rows, [](const auto& row) { return row.front() < 0; })
             ? StateVariable::ydot
             : StateVariable::y;
}

std::size_t velocity_column_index(const std::vector<std::string>& names) {
  constexpr std::string_view kJoint[] = {"p", "density", "pdf", "probability density"};
  if (names.size() != 3 || !is_one_of(names[2], kJoint)) return names.size();
  for (const std::size_t of_v : {1, 0}) {
    if (is_one_of(names[of_v], kSpeed) && is_one_of(names[1 - of_v], kPosition)) return of_v;
  }
  return names.size();
}

StateSamples samples_from_table(const NumberTable& table) {
  const std::size_t columns = table.column_count();
  std::optional<std::size_t> time, displacement, velocity;
  if (table.names.empty()) {
    if (columns == 3) time = 0;
    displacement = columns == 3 ? 1 : 0;
    if (columns > 1) velocity = columns - 1;
  }
  for (std::size_t c = 0; c < table.names.size(); ++c) {
    auto& column = is_one_of(table.names[c], kTime)    ? time
                   : is_one_of(table.names[c], kSpeed) ? velocity
                                                       : displacement;
    if (column || (&column == &displacement && !is_one_of(table.names[c], kPosition))) {
      table.throw_row_error(0, fmt::format("the samples have a column {}; name the columns t, y, v",
                                           base::in_quotes(table.names[c])));
    }
    column = c;
  }
  if (!displacement) table.throw_row_error(0, "the samples have no column y; add it");
  if (time) require_equidistant_times(table, *time);
  return {.y = table.column_values(*displacement),
          .v = velocity ? table.column_values(*velocity) : std::vector<double>()};
}

bool are_bins_adjacent(const std::vector<double>& bin, const std::vector<double>& next) {
  constexpr double kRounding = 1e-6;  // edges are often accumulated sums of widths
  return relative_gap(bin, next) <= kRounding;
}

bool is_histogram(const NumberTable& table) {
  if (table.column_count() != 3) return false;
  const auto& names = table.names;
  const bool named =
      any_of(names, kEdges) || (!names.empty() && (is_one_of(names.back(), kCounts) ||
                                                   is_one_of(names.back(), kProbabilities)));
  if (named) return true;
  // In a table without column names, the second column counts as upper bin edges, not as densities,
  // only if every upper edge is within kMaxGap bin widths of the next lower edge.
  constexpr double kMaxGap = 0.5;  // largest gap between bins, in units of the bin width
  for (std::size_t k = 0; k < table.rows.size(); ++k) {
    if (table.rows[k][1] <= table.rows[k][0]) return false;
    if (k > 0 && relative_gap(table.rows[k - 1], table.rows[k]) > kMaxGap) return false;
  }
  return true;
}

HistogramQuantity detect_histogram_quantity(const NumberTable& histogram) {
  double sum = 0, mass = 0;
  bool whole = true;
  for (const auto& row : histogram.rows) {
    sum += row[2];
    mass += row[2] * (row[1] - row[0]);
    whole = whole && row[2] == std::floor(row[2]);
  }
  if (!histogram.names.empty()) {
    const std::string& value_name = histogram.names.back();
    if (is_one_of(value_name, kProbabilities)) return HistogramQuantity::probability;
    if (is_one_of(value_name, kCounts))
      return is_near_one(sum) ? HistogramQuantity::probability : HistogramQuantity::count;
    if (is_one_of(value_name, kDensities)) return HistogramQuantity::density;
  }
  if (is_near_one(mass)) return HistogramQuantity::density;
  if (is_near_one(sum)) return HistogramQuantity::probability;
  return whole ? HistogramQuantity::count : HistogramQuantity::density;
}

}  // namespace fpkcheck::methods
