#include "workflows/sweep/plan/sweep_plan.hpp"

#include "base/text/parse_number.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/split.hpp>
#include <boost/algorithm/string/trim.hpp>
#include <cmath>

#include "base/input_error.hpp"
#include "base/text/printable_text.hpp"
#include "problem/case_file.hpp"

namespace fpkcheck::sweep {
namespace {

using base::Value;

constexpr std::size_t kMaxValues = 1'000'000;
constexpr std::string_view kLogarithmic = "log:";

// Rounds a number to twelve digits, since 0.57 is easier to read than 0.5700000000000001. Twelve
// digits of a parameter exceed the accuracy of every solver.
double round_to_twelve_digits(double number) {
  return base::parse_number<double>(fmt::format("{:.12g}", number)).value_or(number);
}

std::vector<std::string> split_at(std::string_view text, char separator) {
  std::vector<std::string> parts;
  boost::algorithm::split(parts, text, [separator](char c) { return c == separator; });
  for (auto& part : parts) boost::algorithm::trim(part);
  return parts;
}

struct SweepAxisParser {
  const base::Parameter& parameter;
  std::string label;  ///< label of the key in error messages, e.g. "--vary system.restitution"

  Value value(const std::string& text) const {
    const Value found = base::parse_value(parameter, text, label);
    if (!parameter.is_in_range(found)) {
      throw InputError(fmt::format("{} {} (must be {})", label, base::to_printable_text(text),
                                   parameter.requirement_text()));
    }
    return found;
  }
  double number(const std::string& text) const {
    const Value found = value(text);
    if (const auto* number = std::get_if<double>(&found)) return *number;
    throw InputError(fmt::format("{}: a word has no range (list its values: {})", label,
                                 fmt::join(parameter.choices, ",")));
  }
};

std::size_t parse_value_count(const std::string& text, const SweepAxisParser& reading) {
  const auto count = base::parse_number<std::size_t>(text);
  if (count && *count >= 2 && *count <= kMaxValues) return *count;
  throw InputError(fmt::format("{}: {} is no number of points (must be an integer, 2 .. {})",
                               reading.label, base::in_quotes(text), kMaxValues));
}

SweepAxis parse_axis_range(std::string_view text, SweepAxis axis, const SweepAxisParser& reading) {
  axis.spacing =
      text.starts_with(kLogarithmic) ? SweepAxisSpacing::logarithmic : SweepAxisSpacing::linear;
  if (axis.spacing == SweepAxisSpacing::logarithmic) text.remove_prefix(kLogarithmic.size());
  const auto parts = split_at(text, ':');
  if (parts.size() < 2 || parts.size() > 3) {
    throw InputError(fmt::format("{} {} (write FROM:TO:N, log:FROM:TO:N or A,B,..)", reading.label,
                                 base::to_printable_text(text)));
  }
  axis.from = reading.number(parts[0]);
  axis.to = reading.number(parts[1]);
  if (axis.from == axis.to) {
    throw InputError(fmt::format("{} {} (a range needs two ends that differ)", reading.label,
                                 base::to_printable_text(text)));
  }
  if (axis.spacing == SweepAxisSpacing::logarithmic && std::min(axis.from, axis.to) <= 0) {
    throw InputError(fmt::format("{} log:{} (the ends of a logarithmic range must be positive)",
                                 reading.label, base::to_printable_text(text)));
  }
  if (parts.size() == 2) return axis;
  const std::size_t count = parse_value_count(parts[2], reading);
  axis.values.reserve(count);
  for (std::size_t k = 0; k < count; ++k) {
    axis.values.emplace_back(
        axis.value_at_fraction(static_cast<double>(k) / static_cast<double>(count - 1)));
  }
  return axis;
}

}  // namespace

double SweepAxis::value_at_fraction(double part) const {
  if (part <= 0) return from;
  if (part >= 1) return to;
  return round_to_twelve_digits(spacing == SweepAxisSpacing::logarithmic
                                    ? from * std::pow(to / from, part)
                                    : std::lerp(from, to, part));
}

std::string SweepAxis::axis_definition_text() const {
  if (spacing == SweepAxisSpacing::listed) {
    std::vector<std::string> list;
    for (const auto& value : values) {
      const auto* word = std::get_if<std::string>(&value);
      list.push_back(word != nullptr ? *word : base::value_as_text(value));
    }
    return fmt::format("{} = {}", key, fmt::join(list, ","));
  }
  return fmt::format("{} = {}{:g}:{:g}{}", key,
                     spacing == SweepAxisSpacing::logarithmic ? kLogarithmic : "", from, to,
                     values.empty() ? "" : fmt::format(":{}", values.size()));
}

SweepAxis parse_sweep_axis(std::string_view key, std::string_view values,
                           const std::string& error_context) {
  const SweepAxisParser reading{problem::case_file_parameter(key, error_context),
                                fmt::format("{} {} =", error_context, key)};
  SweepAxis axis{.key = std::string(key)};
  if (values.find(':') != std::string_view::npos) {
    axis = parse_axis_range(values, std::move(axis), reading);
  } else {
    for (const auto& item : split_at(values, ',')) axis.values.push_back(reading.value(item));
  }
  const auto require_distinct = [&reading](const std::vector<Value>& sorted) {
    if (const auto twice = std::ranges::adjacent_find(sorted); twice != sorted.end()) {
      throw InputError(fmt::format("{} {} is given twice (keep one)", reading.label,
                                   base::value_as_text(*twice)));
    }
  };
  if (axis.spacing != SweepAxisSpacing::listed) {
    // The values of a range are sorted already, and a sorted copy would take 40 MB for a million
    // values.
    require_distinct(axis.values);
  } else {
    auto sorted = axis.values;
    std::ranges::sort(sorted);
    require_distinct(sorted);
  }
  return axis;
}

}  // namespace fpkcheck::sweep
