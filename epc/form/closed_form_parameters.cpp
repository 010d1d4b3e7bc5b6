#include "epc/form/closed_form_parameters.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "base/input_error.hpp"
#include "base/text/printable_text.hpp"

namespace fpkcheck::epc {
namespace {

using transform::Metrics;

// Largest power of a monomial in a file with a closed form, verified before memory is allocated.
// Monomials with powers above 40 are unusable in double precision.
constexpr int kHighestPower = 40;

double require_number(const Metrics& metrics, const std::string& path) {
  const auto value = transform::metric_number(metrics, path);
  if (!value || !std::isfinite(*value)) {
    throw InputError(fmt::format("\"{}\" is missing or not finite (must be a number)", path));
  }
  return *value;
}

std::optional<double> optional_positive_number(const Metrics& metrics, const std::string& path) {
  if (transform::find_metric(metrics, path) == nullptr) return std::nullopt;
  const double value = require_number(metrics, path);
  if (!(value > 0)) throw InputError(fmt::format("\"{}\" is {:g} (must be positive)", path, value));
  return value;
}

ExponentCoordinates read_coordinates_of_exponent(const Metrics& metrics) {
  const auto text = transform::metric_text(metrics, "coordinates");
  if (!text) {
    throw InputError(
        "no \"coordinates\" (must be \"x1,x2\", \"y,v\", \"amplitude,phase\" or "
        "\"amplitude,velocity\"); run again if the file is from an earlier version");
  }
  const auto known = base::enum_from_name<ExponentCoordinates>(*text);
  if (!known) {
    throw InputError(
        fmt::format("coordinates {} (must be \"x1,x2\", \"y,v\", \"amplitude,phase\" or "
                    "\"amplitude,velocity\")",
                    base::in_quotes(*text)));
  }
  return *known;
}

int require_power(const Metrics& metrics, const std::string& path) {
  const double value = require_number(metrics, path);
  if (value < 0 || value > kHighestPower || value != std::floor(value)) {
    throw InputError(
        fmt::format("\"{}\" is {:g} (must be an integer, 0 .. {})", path, value, kHighestPower));
  }
  return static_cast<int>(value);
}

std::vector<ExponentMonomial> read_terms(const Metrics& metrics) {
  std::vector<ExponentMonomial> terms;
  constexpr std::size_t kMost = 2000;
  for (std::size_t k = 0;; ++k) {
    const std::string path = fmt::format("coefficients[{}].", k);
    if (transform::find_metric(metrics, path + "x1") == nullptr &&
        transform::find_metric(metrics, path + "a") == nullptr) {
      break;
    }
    if (k == kMost) throw InputError(fmt::format("more than {} coefficients", kMost));
    terms.push_back({require_power(metrics, path + "x1"), require_power(metrics, path + "x2"),
                     require_number(metrics, path + "a")});
  }
  if (terms.empty()) {
    throw InputError("no coefficients (must be a list of {\"x1\": p, \"x2\": q, \"a\": value})");
  }
  return terms;
}

std::optional<double> read_log_constant(const Metrics& metrics) {
  if (transform::find_metric(metrics, "log_C") != nullptr) return require_number(metrics, "log_C");
  const auto constant = optional_positive_number(metrics, "C");
  if (!constant) return std::nullopt;
  return std::log(*constant);
}

std::optional<double> optional_number(const Metrics& metrics, const std::string& path) {
  if (transform::find_metric(metrics, path) == nullptr) return std::nullopt;
  return require_number(metrics, path);
}

problem::WallFrame read_frame_of_coordinates(const Metrics& metrics) {
  problem::WallFrame frame{.origin = optional_number(metrics, "frame.origin").value_or(0)};
  if (const auto* mirrored = transform::find_metric(metrics, "frame.mirrored")) {
    const bool* value = std::get_if<bool>(&mirrored->value);
    if (value == nullptr) {
      throw InputError("\"frame.mirrored\" is not a boolean (must be true or false)");
    }
    frame.mirrored = *value;
  }
  return frame;
}

DensityBoundingBox read_bounding_box(const Metrics& metrics, double y_max, double v_max) {
  const double y_min = optional_number(metrics, "support.y_min").value_or(0);
  if (y_min < y_max) return {y_max, v_max, y_min};
  throw InputError(
      fmt::format("\"support.y_min\" is {:g} (must be below \"y_max\", {:g})", y_min, y_max));
}

}  // namespace

bool has_closed_form(const Metrics& metrics) {
  return transform::find_metric(metrics, "coefficients[0].a") != nullptr;
}

ClosedFormDensity read_closed_form(const Metrics& metrics) {
  ClosedFormDensityParameters frame{.variables = read_coordinates_of_exponent(metrics),
                                    .coordinates = read_frame_of_coordinates(metrics),
                                    .log_constant = read_log_constant(metrics)};
  const auto number = [&](const char* path) { return optional_positive_number(metrics, path); };
  if (frame.variables == ExponentCoordinates::plane ||
      frame.variables == ExponentCoordinates::physical) {
    const auto sigma1 = number("support.sigma1"), sigma2 = number("support.sigma2");
    if (sigma1 && sigma2) frame.deviations = {*sigma1, *sigma2};
  }
  if (frame.variables != ExponentCoordinates::plane) {
    frame.support = number("support.energy").value_or(frame.support);
    if (transform::metric_text(metrics, "tail.kind").value_or("confined") == "confined") {
      frame.level = number("tail.level").value_or(frame.level);
    }
  }
  if (!frame.deviations && !std::isfinite(frame.support)) {
    const auto y_max = number("support.y_max"), v_max = number("support.v_max");
    if (y_max.has_value() != v_max.has_value()) {
      throw InputError("incomplete support: \"y_max\" or \"v_max\" is missing; give both");
    }
    if (y_max) frame.box = read_bounding_box(metrics, *y_max, *v_max);
  }
  return {ExponentPolynomial(read_terms(metrics)), frame};
}

}  // namespace fpkcheck::epc
