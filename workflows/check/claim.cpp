#include "workflows/check/claim.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace fpkcheck::check {
namespace {

using base::Value;

using Key = std::pair<std::string, std::string>;  // solution and name of a quantity

double change(const Claim& was, const Claim& is) {
  const double a = number_in(was.value), b = number_in(is.value), difference = std::abs(b - a);
  if (was.value == is.value || difference == 0) return 0;
  double result = difference / was.scale;
  if (was.kind == FigureKind::simulated_error) {
    result = a > 0 && b > 0 ? std::max(a / b, b / a) - 1 : kInfinity;
  } else if (was.kind == FigureKind::simulated) {
    result = difference / std::hypot(std::isnan(was.error) ? is.error : was.error, is.error);
  }
  return std::isnan(result) ? kInfinity : result;
}

double allowed(const Claim& was, const Claim& is) {
  if (was.kind != FigureKind::simulated_l1) return was.allowed;
  constexpr double kQuantile99 = 2.326;  // of the normal law
  const double expected = std::hypot(was.error, is.error);
  const double deviation = (std::hypot(was.in_99, is.in_99) - expected) / kQuantile99;
  return expected + was.allowed * std::max(deviation, 0.0);
}

bool is_error(const Claim& claim) {
  return claim.kind == FigureKind::simulated_error || claim.name == kStatedError ||
         claim.part == kStatedError;
}

}  // namespace

const Part& Part::begin(FigureKind kind, const Value& what, const std::string& outer) const {
  claims.push_back({.solution = solution,
                    .name = name,
                    .kind = kind,
                    .value = what,
                    .part = name == outer ? "" : outer,
                    .is_head = true});
  return *this;
}

void Part::word(const std::string& of, const Value& value) const {
  claims.push_back({.solution = solution, .name = of, .value = value, .part = name});
}

Claim& Part::number(const std::string& of, FigureKind kind, double value, double allowed,
                    double scale) const {
  return claims.emplace_back(Claim{.solution = solution,
                                   .name = of,
                                   .kind = kind,
                                   .value = std::isfinite(value) ? Value(value) : Value(),
                                   .allowed = allowed,
                                   .scale = scale,
                                   .part = name});
}

double number_in(const Value& value) {
  if (const auto* count = std::get_if<std::int64_t>(&value)) return static_cast<double>(*count);
  const auto* number = std::get_if<double>(&value);
  return number != nullptr ? *number : std::numeric_limits<double>::quiet_NaN();
}

std::vector<Figure> held_against(const std::string& case_name, const Claims& baseline,
                                 const Claims& now) {
  std::map<Key, const Claim*> was_index, is_index;
  for (const Claim& was : baseline) was_index.emplace(Key{was.solution, was.name}, &was);
  for (const Claim& is : now) is_index.emplace(Key{is.solution, is.name}, &is);
  std::vector<Figure> figures;
  std::set<Key> gone;  // parts that differ as a whole, or that one run lacks
  const auto add = [&](const Claim& claim, const Value& was, const Value& is, double change_of_it,
                       double allowed_of_it, bool is_head) {
    const Key key{claim.solution, claim.name};
    const bool is_said = gone.contains({claim.solution, claim.part});
    Figure figure{case_name, claim.solution, claim.name,   claim.kind, was,
                  is,        change_of_it,   allowed_of_it};
    if (is_head && (is_said || figure.moved())) gone.insert(key);
    if (!is_said && (!is_head || figure.moved())) figures.push_back(std::move(figure));
  };
  for (const Claim& was : baseline) {
    const auto found = is_index.find({was.solution, was.name});
    if (found == is_index.end()) {
      add(was, "there", "missing", kInfinity, 0, was.is_head);
    } else {
      const Claim& is = *found->second;
      add(was, was.value, is.value, change(was, is), allowed(was, is), was.is_head || is.is_head);
    }
  }
  for (const Claim& is : now) {
    if (was_index.contains({is.solution, is.name})) continue;
    if (is_error(is)) continue;
    add(is, "missing", "there", kInfinity, 0, is.is_head);
  }
  return figures;
}

}  // namespace fpkcheck::check
