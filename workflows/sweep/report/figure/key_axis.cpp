#include "workflows/sweep/report/figure/key_axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "problem/case_file.hpp"
#include "report/figure/gnuplot.hpp"

namespace fpkcheck::sweep {
namespace {

using base::Value;

constexpr std::size_t kMaxTics = 6;

// Returns at least kMaxTics / 2 tic positions, which are multiples of 1, 2 or 5 times a power of
// ten.
std::vector<double> round_tics(double low, double high) {
  const double rough = (high - low) / static_cast<double>(kMaxTics);
  const double power = std::pow(10, std::floor(std::log10(rough)));
  double step = 10 * power;
  for (const double digit : {5.0, 2.0, 1.0}) {
    if (digit * power >= rough) step = digit * power;
  }
  std::vector<double> numbers;
  for (double k = std::ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k) {
    numbers.push_back(k == 0 ? 0 : k * step);
  }
  return numbers;
}

std::vector<double> round_tics_by_decades(double low, double high) {
  std::vector<double> numbers;
  for (const auto& digits : {std::vector{1.0, 2.0, 5.0}, {1.0, 3.0}, {1.0}}) {
    numbers.clear();
    for (double power = std::floor(std::log10(low)); power <= std::log10(high); ++power) {
      for (const double digit : digits) {
        const double number = digit * std::pow(10, power);
        if (number >= low * (1 - 1e-9) && number <= high * (1 + 1e-9)) numbers.push_back(number);
      }
    }
    if (numbers.size() <= kMaxTics) break;
  }
  return numbers.size() < 2 ? round_tics(low, high) : numbers;
}

// Returns whether the largest value of a list exceeds the smallest value by a factor above 20.
// Values that differ by a factor above 20 are drawn on a logarithmic axis.
bool spans_decades(const std::vector<Value>& sorted) {
  constexpr double kDecadeRatio = 20;
  const double low = std::get<double>(sorted.front()), high = std::get<double>(sorted.back());
  return low > 0 && high > kDecadeRatio * low;
}

}  // namespace

SweepParameterAxis::SweepParameterAxis(const SweepPlan& plan, std::size_t axis_index)
    : key_(plan.axes[axis_index].key) {
  const SweepAxis& axis = plan.axes[axis_index];
  const auto& parameter = problem::case_file_parameter(key_, "a picture");
  label_ = report::escape_enhanced_text(key_);
  if (!parameter.typeset.empty()) {
    label_ += fmt::format(", {{/:Italic {}}}", report::escape_enhanced_text(parameter.typeset));
  }
  values_ = axis.values;
  if (values_.empty()) {
    for (const auto& point : plan.points) values_.push_back(point[axis_index]);
  }
  is_words_ = !values_.empty() && !std::holds_alternative<double>(values_.front());
  if (is_words_) return;
  std::ranges::sort(values_);
  values_.erase(std::unique(values_.begin(), values_.end()), values_.end());
  is_even_ = axis.spacing != SweepAxisSpacing::listed && values_.size() > 1;
  is_logarithmic_ = axis.spacing == SweepAxisSpacing::logarithmic ||
                    (axis.spacing == SweepAxisSpacing::listed && spans_decades(values_));
}

std::string SweepParameterAxis::parameter_value_text(const Value& value) {
  const auto* number = std::get_if<double>(&value);
  return number != nullptr ? fmt::format("{:.4g}", *number) : std::get<std::string>(value);
}

double SweepParameterAxis::coordinate(const Value& value) const {
  return is_words_ ? static_cast<double>(map_cell_index(value)) : std::get<double>(value);
}

double SweepParameterAxis::relative_figure_coordinate(const Value& value) const {
  const double from = coordinate(values_.front()), to = coordinate(values_.back()),
               here = coordinate(value);
  if (from == to) return 0;
  return is_logarithmic_ ? std::log(here / from) / std::log(to / from)
                         : (here - from) / (to - from);
}

report::FigureAxis SweepParameterAxis::figure_axis() const {
  if (is_words_) return figure_axis_of_cells();
  const double low = std::get<double>(values_.front()), high = std::get<double>(values_.back());
  constexpr double kRoom = 0.03;  // margin for marks at each end, as a fraction of the range
  if (is_logarithmic_) {
    const double room = low == high ? 2 : std::pow(high / low, kRoom);
    report::FigureAxis axis{label_, low / room, high * room, true};
    for (const double number : round_tics_by_decades(low, high)) {
      axis.tics.push_back({fmt::format("{:g}", number), number});
    }
    return axis;
  }
  const double room = low == high ? std::max(std::abs(low), 1.0) : kRoom * (high - low);
  return {label_, low - room, high + room};
}

std::size_t SweepParameterAxis::map_cell_index(const Value& value) const {
  return static_cast<std::size_t>(std::ranges::find(values_, value) - values_.begin());
}

report::FigureAxis SweepParameterAxis::figure_axis_of_cells() const {
  const double last = static_cast<double>(values_.size()) - 1;
  report::FigureAxis axis{label_, -0.5, last + 0.5};
  if (is_even_) {
    const double low = std::get<double>(values_.front()), high = std::get<double>(values_.back());
    const auto numbers = is_logarithmic_ ? round_tics_by_decades(low, high) : round_tics(low, high);
    for (const double number : numbers) {
      axis.tics.push_back({fmt::format("{:g}", number), relative_figure_coordinate(number) * last});
    }
  } else {
    const std::size_t step = is_words_ ? 1 : (values_.size() + kMaxTics - 1) / kMaxTics;
    for (std::size_t k = 0; k < values_.size(); k += step) {
      axis.tics.push_back(
          {report::escape_enhanced_text(parameter_value_text(values_[k])), static_cast<double>(k)});
    }
  }
  return axis;
}

}  // namespace fpkcheck::sweep
