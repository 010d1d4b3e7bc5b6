#include "workflows/sweep/map/validity_map.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <limits>

#include "base/input_error.hpp"
#include "base/text/sanitise.hpp"
#include "problem/features.hpp"
#include "problem/scales.hpp"

namespace fpkcheck::sweep {

DimensionlessGroups dimensionless_groups(const problem::Problem& problem) {
  const auto& system = problem.system.coefficients();
  const auto scales = problem::scales(problem);
  const double stiffness = scales.frequency * scales.frequency;
  const bool original = problem::is_paper_oscillator(problem);
  return {.impulses_per_decay_time = problem::impulses_per_decay_time(problem, scales),
          .damping_ratio = system.damping / (2 * scales.frequency),
          .cubic_share = original ? 1 - system.stiffness / stiffness
                                  : std::numeric_limits<double>::quiet_NaN()};
}

namespace {

using transform::Status;

constexpr std::array<std::string_view, 6> kCoordinateColumns{
    "impulses_per_decay_time", "damping_ratio", "cubic_share", "restitution", "law", "mean_share"};

struct StatusLetter {
  char letter;
  Status status;
  bool underestimated = false;
};
constexpr StatusLetter kStatusLetters[] = {
    {'o', Status::ok},           {'x', Status::ok, true},      {'i', Status::inaccurate},
    {'a', Status::inadmissible}, {'n', Status::not_converged}, {'p', Status::ill_posed},
    {'f', Status::failed},       {'u', Status::not_offered}};

bool is_status_letter(char c) {
  return std::ranges::find(kStatusLetters, c, &StatusLetter::letter) != std::end(kStatusLetters);
}

std::vector<std::string_view> split_at(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (;;) {
    const auto end = text.find(separator);
    parts.push_back(text.substr(0, end));
    if (end == text.npos) return parts;
    text.remove_prefix(end + 1);
  }
}

// Parses a finite number that is not negative. All numbers of the map are fractions, ratios,
// distances or times.
std::optional<double> parse_nonnegative(std::string_view text) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  if (!std::isfinite(number) || number < 0) return std::nullopt;
  return number;
}

/// A line of the map, with the location of the line for error messages.
struct MapLine {
  std::string_view text;
  std::string where;

  [[noreturn]] void throw_error(std::string_view part, const std::string& expected) const {
    throw InputError(
        fmt::format("{}: {} ({})", where, base::in_quotes(std::string(part)), expected));
  }

  double number(std::string_view part) const {
    const auto found = parse_nonnegative(part);
    if (!found) throw_error(part, "must be a number that is not negative");
    return *found;
  }
};

std::optional<MappedResult> parse_result(const MapLine& line, std::string_view cell) {
  if (cell.empty()) return std::nullopt;
  // The letter "e" of a decimal exponent is not a status letter.
  const auto at =
      static_cast<std::size_t>(std::ranges::find_if(cell, is_status_letter) - cell.begin());
  if (at == cell.size()) {
    line.throw_error(cell, "must be L1, letter of a status, milliseconds: .004o310");
  }
  const auto* const entry = std::ranges::find(kStatusLetters, cell[at], &StatusLetter::letter);
  MappedResult answer{.status = entry->status,
                      .l1 = {},
                      .underestimated = entry->underestimated,
                      .seconds = line.number(cell.substr(at + 1)) / 1000};
  if (at > 0) answer.l1 = line.number(cell.substr(0, at));
  if (!answer.l1 && answer.is_ok()) line.throw_error(cell, "ok without L1");
  return answer;
}

MappedPoint parse_point(const MapLine& line, std::size_t methods) {
  const auto cells = split_at(line.text, ',');
  if (cells.size() != kCoordinateColumns.size() + methods) {
    throw InputError(fmt::format("{}: {} columns (must be {}, as in the first line)", line.where,
                                 cells.size(), kCoordinateColumns.size() + methods));
  }
  MappedPoint point{.coordinates = {.groups = {.impulses_per_decay_time = line.number(cells[0]),
                                               .damping_ratio = line.number(cells[1]),
                                               .cubic_share = line.number(cells[2])},
                                    .restitution = line.number(cells[3]),
                                    .law = std::string(cells[4]),
                                    .relative_mean = line.number(cells[5])},
                    .method_results = {}};
  // The distance between problems contains the logarithms of these two numbers, which must
  // therefore be positive.
  for (const std::size_t k : {0, 1}) {
    if (line.number(cells[k]) == 0) line.throw_error(cells[k], "must be above 0");
  }
  for (std::size_t m = 0; m < methods; ++m) {
    point.method_results.push_back(parse_result(line, cells[kCoordinateColumns.size() + m]));
  }
  if (!point.method_results.back() || !point.method_results.back()->l1) {
    throw InputError(line.where + ": no L1 of the last method (it is the reference)");
  }
  return point;
}

}  // namespace

ValidityMap read_validity_map(std::string_view text, const std::string& where) {
  auto lines = split_at(text, '\n');
  if (lines.back().empty()) lines.pop_back();
  const auto header = lines.empty() ? std::vector<std::string_view>() : split_at(lines[0], ',');
  if (header.size() <= kCoordinateColumns.size() ||
      !std::equal(kCoordinateColumns.begin(), kCoordinateColumns.end(), header.begin())) {
    throw InputError(fmt::format("{} is no map of validity (make one by scripts/validity)", where));
  }
  ValidityMap map;
  map.methods.assign(header.begin() + kCoordinateColumns.size(), header.end());
  for (std::size_t k = 1; k < lines.size(); ++k) {
    map.points.push_back(
        parse_point({lines[k], fmt::format("{}:{}", where, k + 1)}, map.methods.size()));
  }
  return map;
}

MapCoordinates map_coordinates(const problem::Problem& problem) {
  const auto& impulses = problem.impulses.parameters();
  const auto& law = problem.impulses.law();
  return {.groups = dimensionless_groups(problem),
          .restitution = problem.system.restitution(),
          .law = law.is_symmetric()
                     ? impulses.law
                     : fmt::format("{} of skewness {:g}", impulses.law, law.skewness()),
          .relative_mean = impulses.mean / std::sqrt(impulses.intensity / impulses.arrival_rate)};
}

double map_distance(const MapCoordinates& one, const MapCoordinates& other) {
  constexpr double kRestitutionUnit = 0.1, kCubicUnit = 0.2;
  if (one.law != other.law || one.relative_mean != other.relative_mean) {
    return std::numeric_limits<double>::infinity();
  }
  const double impulses =
      std::log(one.groups.impulses_per_decay_time / other.groups.impulses_per_decay_time);
  const double damping = std::log(one.groups.damping_ratio / other.groups.damping_ratio);
  const double losses = (one.restitution - other.restitution) / kRestitutionUnit;
  const double cubic = (one.groups.cubic_share - other.groups.cubic_share) / kCubicUnit;
  return std::hypot(std::hypot(impulses, damping), std::hypot(losses, cubic));
}

}  // namespace fpkcheck::sweep
