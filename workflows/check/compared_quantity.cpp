#include "workflows/check/compared_quantity.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace fpkcheck::check {
namespace {

using base::Value;

using QuantityKey = std::pair<std::string, std::string>;  // solution and name of a quantity

double scaled_change(const CheckedQuantity& was, const CheckedQuantity& is) {
  const double a = finite_number_or_nan(was.value), b = finite_number_or_nan(is.value),
               difference = std::abs(b - a);
  if (was.value == is.value || difference == 0) return 0;
  double result = difference / was.scale;
  if (was.kind == CheckedQuantityKind::simulated_error) {
    result = a > 0 && b > 0 ? std::max(a / b, b / a) - 1 : kInfinity;
  } else if (was.kind == CheckedQuantityKind::simulated) {
    result = difference / std::hypot(std::isnan(was.error) ? is.error : was.error, is.error);
  }
  return std::isnan(result) ? kInfinity : result;
}

double allowed_change(const CheckedQuantity& was, const CheckedQuantity& is) {
  if (was.kind != CheckedQuantityKind::simulated_l1) return was.allowed;
  constexpr double kNormalQuantile99 = 2.326;  // quantile of the standard normal law
  const double expected = std::hypot(was.error, is.error);
  const double deviation =
      (std::hypot(was.quantile_99, is.quantile_99) - expected) / kNormalQuantile99;
  return expected + was.allowed * std::max(deviation, 0.0);
}

bool is_error_estimate(const CheckedQuantity& quantity) {
  return quantity.kind == CheckedQuantityKind::simulated_error ||
         quantity.name == kErrorEstimatePart || quantity.part == kErrorEstimatePart;
}

}  // namespace

const SolutionPartQuantityAppender& SolutionPartQuantityAppender::begin_part(
    CheckedQuantityKind kind, const Value& value, const std::string& enclosing_part) const {
  quantities.push_back({.solution = solution,
                        .name = name,
                        .kind = kind,
                        .value = value,
                        .part = name == enclosing_part ? "" : enclosing_part,
                        .opens_part = true});
  return *this;
}

void SolutionPartQuantityAppender::append_word_quantity(const std::string& quantity_name,
                                                        const Value& value) const {
  quantities.push_back({.solution = solution, .name = quantity_name, .value = value, .part = name});
}

CheckedQuantity& SolutionPartQuantityAppender::append_number_quantity(
    const std::string& quantity_name, CheckedQuantityKind kind, double value, double allowed,
    double scale) const {
  return quantities.emplace_back(
      CheckedQuantity{.solution = solution,
                      .name = quantity_name,
                      .kind = kind,
                      .value = std::isfinite(value) ? Value(value) : Value(),
                      .allowed = allowed,
                      .scale = scale,
                      .part = name});
}

double finite_number_or_nan(const Value& value) {
  if (const auto* count = std::get_if<std::int64_t>(&value)) return static_cast<double>(*count);
  const auto* number = std::get_if<double>(&value);
  return number != nullptr ? *number : std::numeric_limits<double>::quiet_NaN();
}

std::vector<CheckedQuantityChange> compare_quantities(const std::string& case_name,
                                                      const CheckedQuantities& baseline,
                                                      const CheckedQuantities& now) {
  std::map<QuantityKey, const CheckedQuantity*> was_index, is_index;
  for (const CheckedQuantity& was : baseline)
    was_index.emplace(QuantityKey{was.solution, was.name}, &was);
  for (const CheckedQuantity& is : now) is_index.emplace(QuantityKey{is.solution, is.name}, &is);
  std::vector<CheckedQuantityChange> changes;
  std::set<QuantityKey> excluded_parts;  // parts that differ completely, or that only one run has
  const auto add = [&](const CheckedQuantity& quantity, const Value& was, const Value& is,
                       double change_value, double tolerance, bool opens_part) {
    const QuantityKey key{quantity.solution, quantity.name};
    const bool is_in_excluded_part = excluded_parts.contains({quantity.solution, quantity.part});
    CheckedQuantityChange quantity_change{
        case_name, quantity.solution, quantity.name, quantity.kind, was,
        is,        change_value,      tolerance};
    if (opens_part && (is_in_excluded_part || quantity_change.exceeds_tolerance()))
      excluded_parts.insert(key);
    if (!is_in_excluded_part && (!opens_part || quantity_change.exceeds_tolerance()))
      changes.push_back(std::move(quantity_change));
  };
  for (const CheckedQuantity& was : baseline) {
    const auto found = is_index.find({was.solution, was.name});
    if (found == is_index.end()) {
      add(was, "there", "missing", kInfinity, 0, was.opens_part);
    } else {
      const CheckedQuantity& is = *found->second;
      add(was, was.value, is.value, scaled_change(was, is), allowed_change(was, is),
          was.opens_part || is.opens_part);
    }
  }
  for (const CheckedQuantity& is : now) {
    if (was_index.contains({is.solution, is.name})) continue;
    if (is_error_estimate(is)) continue;
    add(is, "missing", "there", kInfinity, 0, is.opens_part);
  }
  return changes;
}

}  // namespace fpkcheck::check
