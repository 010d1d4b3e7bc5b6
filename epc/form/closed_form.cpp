#include "epc/form/closed_form.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "base/input_error.hpp"
#include "base/text/shown.hpp"

namespace fpkcheck::epc {
namespace {

using transform::Observations;

// Above every power that rounding leaves usable; checked before memory is allocated.
constexpr int kHighestPower = 40;

double required(const Observations& observations, const std::string& path) {
  const auto value = transform::number(observations, path);
  if (!value || !std::isfinite(*value)) {
    throw InputError(fmt::format("\"{}\" is missing or not finite (must be a number)", path));
  }
  return *value;
}

std::optional<double> positive_if_any(const Observations& observations, const std::string& path) {
  if (transform::find(observations, path) == nullptr) return std::nullopt;
  const double value = required(observations, path);
  if (!(value > 0)) throw InputError(fmt::format("\"{}\" is {:g} (must be positive)", path, value));
  return value;
}

Variables variables_in(const Observations& observations) {
  const auto text = transform::word(observations, "coordinates");
  if (!text) {
    throw InputError(
        "no \"coordinates\" (must be \"x1,x2\", \"y,v\", \"amplitude,phase\" or "
        "\"amplitude,velocity\"); run again if the file is from an earlier version");
  }
  const auto known = base::value_named<Variables>(*text);
  if (!known) {
    throw InputError(
        fmt::format("coordinates {} (must be \"x1,x2\", \"y,v\", \"amplitude,phase\" or "
                    "\"amplitude,velocity\")",
                    base::in_quotes(*text)));
  }
  return *known;
}

int power(const Observations& observations, const std::string& path) {
  const double value = required(observations, path);
  if (value < 0 || value > kHighestPower || value != std::floor(value)) {
    throw InputError(
        fmt::format("\"{}\" is {:g} (must be an integer, 0 .. {})", path, value, kHighestPower));
  }
  return static_cast<int>(value);
}

// Files store the coefficients in order of k: each search starts at the position of the last one.
std::vector<Term> terms_in(const Observations& observations) {
  std::vector<Term> terms;
  constexpr std::size_t kMost = 2000;
  for (std::size_t k = 0;; ++k) {
    const std::string path = fmt::format("coefficients[{}].", k);
    if (transform::find(observations, path + "x1") == nullptr &&
        transform::find(observations, path + "a") == nullptr) {
      break;
    }
    if (k == kMost) throw InputError(fmt::format("more than {} coefficients", kMost));
    terms.push_back({power(observations, path + "x1"), power(observations, path + "x2"),
                     required(observations, path + "a")});
  }
  if (terms.empty()) {
    throw InputError("no coefficients (must be a list of {\"x1\": p, \"x2\": q, \"a\": value})");
  }
  return terms;
}

std::optional<double> log_constant_in(const Observations& observations) {
  if (transform::find(observations, "log_C") != nullptr) return required(observations, "log_C");
  const auto constant = positive_if_any(observations, "C");
  if (!constant) return std::nullopt;
  return std::log(*constant);
}

std::optional<double> any_number(const Observations& observations, const std::string& path) {
  if (transform::find(observations, path) == nullptr) return std::nullopt;
  return required(observations, path);
}

problem::Frame coordinates_in(const Observations& observations) {
  problem::Frame frame{.origin = any_number(observations, "frame.origin").value_or(0)};
  if (const auto* mirrored = transform::find(observations, "frame.mirrored")) {
    const bool* value = std::get_if<bool>(&mirrored->value);
    if (value == nullptr) {
      throw InputError("\"frame.mirrored\" is not a boolean (must be true or false)");
    }
    frame.mirrored = *value;
  }
  return frame;
}

Box box_in(const Observations& observations, double y_max, double v_max) {
  const double y_min = any_number(observations, "support.y_min").value_or(0);
  if (y_min < y_max) return {y_max, v_max, y_min};
  throw InputError(
      fmt::format("\"support.y_min\" is {:g} (must be below \"y_max\", {:g})", y_min, y_max));
}

}  // namespace

bool has_closed_form(const Observations& observations) {
  return transform::find(observations, "coefficients[0].a") != nullptr;
}

ClosedForm closed_form_in(const Observations& observations) {
  Frame frame{.variables = variables_in(observations),
              .coordinates = coordinates_in(observations),
              .log_constant = log_constant_in(observations)};
  const auto number = [&](const char* path) { return positive_if_any(observations, path); };
  if (frame.variables == Variables::plane || frame.variables == Variables::physical) {
    const auto sigma1 = number("support.sigma1"), sigma2 = number("support.sigma2");
    if (sigma1 && sigma2) frame.deviations = {*sigma1, *sigma2};
  }
  if (frame.variables != Variables::plane) {
    frame.support = number("support.energy").value_or(frame.support);
    if (transform::word(observations, "tail.kind").value_or("confined") == "confined") {
      frame.level = number("tail.level").value_or(frame.level);
    }
  }
  if (!frame.deviations && !std::isfinite(frame.support)) {
    const auto y_max = number("support.y_max"), v_max = number("support.v_max");
    if (y_max.has_value() != v_max.has_value()) {
      throw InputError("half a support: \"y_max\" or \"v_max\" is missing; give both");
    }
    if (y_max) frame.box = box_in(observations, *y_max, *v_max);
  }
  return {Polynomial(terms_in(observations)), frame};
}

}  // namespace fpkcheck::epc
