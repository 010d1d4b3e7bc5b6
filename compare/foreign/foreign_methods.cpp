#include "compare/foreign/foreign_methods.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "compare/figure/pictures.hpp"
#include "compare/foreign/foreign_marginal.hpp"
#include "problem/input_error.hpp"

namespace fpkcheck::compare {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using transform::Variable;

struct Argument {
  fs::path file;
  std::string label;
};

// A file's name may have colons itself.
Argument parse(const std::string& text) {
  std::error_code ignored;
  const auto colon = text.rfind(':');
  if (colon == std::string::npos || fs::exists(text, ignored)) {
    return {text, picture_stem(fs::path(text).stem().string())};
  }
  return {text.substr(0, colon), text.substr(colon + 1)};
}

void require_free(const std::string& label) {
  constexpr std::size_t kLongest = 24;  // the table has 80 columns
  const bool legal = !label.empty() && label.size() <= kLongest && picture_stem(label) == label;
  if (!legal) {
    throw InputError(
        fmt::format("--against: label '{}' (must be 1 to {} letters, digits, '-', '_' or '.': "
                    "FILE:LABEL)",
                    label, kLongest));
  }
  for (const char* family : {"epc", "fd", "mcs"}) {
    if (label == family || label.starts_with(std::string(family) + '-')) {
      throw InputError(
          fmt::format("--against: label '{}' is a method's (choose another: FILE:LABEL)", label));
    }
  }
}

double unknown() { return std::numeric_limits<double>::quiet_NaN(); }

// The comparison does not see what lies there.
void say_what_lies_beyond(const ForeignMarginal& marginal, const std::vector<double>& bins,
                          Json& file) {
  constexpr double kSmall = 1e-3;
  const double share = marginal.share_beyond(bins.front(), bins.back());
  file["beyond_axes"] = share;
  if (share <= kSmall) return;
  file["notes"].push_back(fmt::format(
      "{:.3g} % of it lies beyond the axes of the comparison, {} = {:.3g} to {:.3g}, and does not "
      "count (other units?)",
      100 * share, marginal.variable() == Variable::y ? "y" : "y'", bins.front(), bins.back()));
}

// @param place among the solutions from files, to tell them apart in pictures
Entry entry(const std::string& label, std::size_t place,
            const std::vector<ForeignMarginal>& marginals, const ComparisonAxes& axes) {
  transform::Solution solution{.id = label, .method = "file", .equation = "given"};
  solution.status = transform::Status::ok;
  solution.energy_residual = unknown();
  auto& m = solution.moments;
  m = {unknown(), unknown(), unknown(), unknown(), unknown(), unknown()};
  Json files = Json::array(), sampling = Json::object();
  for (const auto& marginal : marginals) {
    const bool of_y = marginal.variable() == Variable::y;
    (of_y ? m.y1 : m.v1) = marginal.moment(1);
    (of_y ? m.y2 : m.v2) = marginal.moment(2);
    (of_y ? m.y4 : m.v4) = marginal.moment(4);
    const auto& bins = edges(axes, marginal.variable());
    auto on_axes = marginal.on(bins);
    const double mass = marginal.moment(0);
    const auto [least, most] = std::ranges::minmax(on_axes.density);
    const double min_density = most > 0 ? least / most : 0;
    const bool first = &marginal == &marginals.front();
    // Of several files the worse.
    if (first || std::abs(mass - 1) > std::abs(solution.mass - 1)) solution.mass = mass;
    if (first || min_density < solution.min_density) solution.min_density = min_density;
    if (marginal.has_errors()) {
      const std::string variable(transform::name(marginal.variable()));
      const auto [expected, in_99] = marginal.sampling_l1(bins);
      sampling[variable] = expected;
      sampling[variable + "_99"] = in_99;
    }
    Json file = marginal.description();
    file["mass"] = mass;
    file["min_density"] = min_density;
    say_what_lies_beyond(marginal, bins, file);
    files.push_back(std::move(file));
    solution.estimated_marginals.emplace_back(marginal.variable(), std::move(on_axes));
  }
  Json details{{"files", files}, {"place", place}};
  if (!sampling.empty()) details["sampling_l1"] = sampling;
  return {std::move(solution), Json::object(), std::move(details)};
}

}  // namespace

std::vector<Method> foreign_methods(std::span<const std::string> arguments) {
  struct Foreign {
    std::string label;
    std::vector<ForeignMarginal> marginals;
  };
  std::vector<Foreign> solutions;
  for (const auto& text : arguments) {
    const auto [file, label] = parse(text);
    require_free(label);
    auto marginal = read_foreign_marginal(file);
    auto own = std::ranges::find(solutions, label, &Foreign::label);
    if (own == solutions.end()) own = solutions.insert(own, {label, {}});
    if (std::ranges::find(own->marginals, marginal.variable(), &ForeignMarginal::variable) !=
        own->marginals.end()) {
      throw InputError(fmt::format(
          "--against: two files of '{}' are densities of {} (name another label: FILE:LABEL)",
          label, marginal.variable() == Variable::y ? "y" : "y'"));
    }
    own->marginals.push_back(std::move(marginal));
  }
  std::vector<Method> methods;
  for (auto& [label, marginals] : solutions) {
    methods.push_back(
        {.id = label,
         .solve = [label = label, place = methods.size(), marginals = marginals](
                      const problem::Problem&, const ComparisonAxes& axes, const Fraction&) {
           return entry(label, place, marginals, axes);
         }});
  }
  return methods;
}

}  // namespace fpkcheck::compare
