#include "workflows/sweep/map/validity_map.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

#include "base/input_error.hpp"
#include "base/text/parse_number.hpp"
#include "base/text/printable_text.hpp"
#include "problem/equivalent_linearisation.hpp"
#include "problem/motion_scales.hpp"
#include "problem/problem_features.hpp"

namespace fpkcheck::sweep {

DimensionlessGroups dimensionless_groups(const problem::Problem& problem) {
  const auto& system = problem.system.coefficients();
  const auto scales = problem::motion_scales(problem);
  const double stiffness = scales.frequency * scales.frequency;
  const bool original = problem::has_equivalent_linearisation(problem);
  return {.impulses_per_decay_time = problem::impulses_per_decay_time(problem, scales),
          .damping_ratio = system.damping / (2 * scales.frequency),
          .cubic_share = original ? 1 - system.stiffness / stiffness
                                  : std::numeric_limits<double>::quiet_NaN()};
}

namespace {

using transform::Status;

constexpr std::array<std::string_view, 6> kCoordinateColumns{
    "impulses_per_decay_time", "damping_ratio", "cubic_share", "restitution", "law", "mean_share"};

struct SolutionStatusLetter {
  char letter;
  Status status;
  bool underestimated = false;
};
constexpr SolutionStatusLetter kStatusLetters[] = {
    {'o', Status::ok},           {'x', Status::ok, true},      {'i', Status::inaccurate},
    {'a', Status::inadmissible}, {'n', Status::not_converged}, {'p', Status::ill_posed},
    {'f', Status::failed},       {'u', Status::not_offered}};

bool is_status_letter(char c) {
  return std::ranges::find(kStatusLetters, c, &SolutionStatusLetter::letter) !=
         std::end(kStatusLetters);
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

[[noreturn]] void refuse(std::string_view text) {
  throw InputError(fmt::format("validity map: {} is invalid (make the map by scripts/validity)",
                               base::in_quotes(text)));
}

// Parses a nonnegative number. All numbers of a validity map are nonnegative: fractions, ratios,
// distances or times.
double parse_nonnegative_number(std::string_view text) {
  const auto number = base::parse_number<double>(text);
  if (!number || !std::isfinite(*number) || *number < 0) refuse(text);
  return *number;
}

std::optional<ValidityMapResult> parse_result_cell(std::string_view cell) {
  if (cell.empty()) return std::nullopt;
  // The letter "e" of a decimal exponent is not a status letter of the validity map.
  const auto at =
      static_cast<std::size_t>(std::ranges::find_if(cell, is_status_letter) - cell.begin());
  if (at == cell.size()) refuse(cell);
  const auto* const entry =
      std::ranges::find(kStatusLetters, cell[at], &SolutionStatusLetter::letter);
  ValidityMapResult answer{.status = entry->status,
                           .l1 = {},
                           .underestimated = entry->underestimated,
                           .seconds = parse_nonnegative_number(cell.substr(at + 1)) / 1000};
  if (at > 0) answer.l1 = parse_nonnegative_number(cell.substr(0, at));
  if (!answer.l1 && answer.has_status_ok()) refuse(cell);
  return answer;
}

ValidityMapPoint parse_map_point(std::string_view line, std::size_t methods) {
  const auto cells = split_at(line, ',');
  if (cells.size() != kCoordinateColumns.size() + methods) refuse(line);
  ValidityMapPoint point{
      .coordinates = {.groups = {.impulses_per_decay_time = parse_nonnegative_number(cells[0]),
                                 .damping_ratio = parse_nonnegative_number(cells[1]),
                                 .cubic_share = parse_nonnegative_number(cells[2])},
                      .restitution = parse_nonnegative_number(cells[3]),
                      .law = std::string(cells[4]),
                      .relative_mean = parse_nonnegative_number(cells[5])},
      .method_results = {}};
  // The distance in the validity map contains the logarithms of impulses per decay time and damping
  // ratio.
  const auto& groups = point.coordinates.groups;
  if (groups.impulses_per_decay_time == 0 || groups.damping_ratio == 0) refuse(line);
  for (std::size_t m = 0; m < methods; ++m) {
    point.method_results.push_back(parse_result_cell(cells[kCoordinateColumns.size() + m]));
  }
  // The last method of the validity map is the reference, which must have an error estimate at
  // every point.
  if (!point.method_results.back() || !point.method_results.back()->l1) refuse(line);
  return point;
}

}  // namespace

ValidityMap read_validity_map(std::string_view text) {
  auto lines = split_at(text, '\n');
  if (lines.back().empty()) lines.pop_back();
  const auto header = lines.empty() ? std::vector<std::string_view>() : split_at(lines[0], ',');
  if (header.size() <= kCoordinateColumns.size() ||
      !std::equal(kCoordinateColumns.begin(), kCoordinateColumns.end(), header.begin())) {
    refuse(lines.empty() ? "" : lines[0]);
  }
  ValidityMap map;
  map.methods.assign(header.begin() + kCoordinateColumns.size(), header.end());
  for (std::size_t k = 1; k < lines.size(); ++k) {
    map.points.push_back(parse_map_point(lines[k], map.methods.size()));
  }
  return map;
}

ValidityMapCoordinates validity_map_coordinates(const problem::Problem& problem) {
  const auto& impulses = problem.impulses.impulse_parameters();
  const auto& law = problem.impulses.amplitude_law();
  return {.groups = dimensionless_groups(problem),
          .restitution = problem.system.restitution(),
          .law = law.is_symmetric()
                     ? impulses.law
                     : fmt::format("{} of skewness {:g}", impulses.law, law.skewness()),
          .relative_mean = impulses.mean / std::sqrt(impulses.intensity / impulses.arrival_rate)};
}

double validity_map_distance(const ValidityMapCoordinates& one,
                             const ValidityMapCoordinates& other) {
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
