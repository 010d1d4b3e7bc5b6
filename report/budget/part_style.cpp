#include "report/budget/part_style.hpp"

#include <fmt/format.h>

#include "compare/error_budget.hpp"

namespace fpkcheck::report {
namespace {

struct PartStyle {
  const char* colour;
  const char* pattern;  ///< fill pattern of plotly.js; "" for none
  int hatch;            ///< fill pattern of gnuplot; 0 for none
};

// Colours of Okabe and Ito, which are distinct for colour-blind readers; hatching distinguishes
// colours that are equal in grey print.
PartStyle part_style(const std::string& part) {
  using compare::Approximation;
  const auto approximations = compare::parse_approximations(part);
  if (approximations.size() > 1) return {"#999999", ".", 2};
  switch (approximations.front()) {
    case Approximation::closure:
      return {"#D55E00", "", 0};
    case Approximation::impact:
      return {"#E69F00", "/", 4};
    case Approximation::truncation:
      return {"#0072B2", "", 0};
    case Approximation::white_noise:
      return {"#009E73", "|", 6};
    case Approximation::discretisation:
      return {"#56B4E9", "\\", 5};
    case Approximation::sampling:
      break;
  }
  return {"#CC79A7", "x", 1};
}

}  // namespace

const char* budget_part_colour(const std::string& part) { return part_style(part).colour; }

std::string budget_part_bar_style(const std::string& part, bool faint) {
  const auto& [colour, pattern, hatch] = part_style(part);
  if (hatch == 0) {
    return fmt::format("with boxes fillstyle solid {} border rgb '{}' linecolor rgb '{}'",
                       faint ? 0.3 : 1.0, colour, colour);
  }
  // gnuplot has no fill density for patterns: the colour of a pattern is mixed with white instead,
  // with the fraction 0.3 as for solid bars.
  std::string hatch_colour = "#";
  for (const std::size_t position : {1, 3, 5}) {
    const int part_of_colour = std::stoi(std::string(colour).substr(position, 2), nullptr, 16);
    hatch_colour +=
        fmt::format("{:02X}", faint ? 255 - 3 * (255 - part_of_colour) / 10 : part_of_colour);
  }
  return fmt::format("with boxes fillstyle pattern {} border rgb '{}' linecolor rgb '{}'", hatch,
                     colour, hatch_colour);
}

const char* budget_part_fill_pattern(const std::string& part) { return part_style(part).pattern; }

}  // namespace fpkcheck::report
