#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string_view>

#include "base/options/enum_names.hpp"
#include "epc/form/polynomial.hpp"
#include "epc/form/rays.hpp"
#include "problem/frame.hpp"
#include "transform/metric.hpp"

namespace fpkcheck::epc {

/// Coordinates of the polynomial Q_n.
enum class Variables {
  plane,     ///< z and z' of Zhuravlev's plane: p(y, v) = C (exp Q(y, v) + exp Q(-y, -v))
  physical,  ///< y and v: p(y, v) = C exp Q(y, v)
  polar,     ///< amplitude and phase, polar::Coordinates: p(y, v) = C exp Q(rho, theta)
  /// amplitude and velocity, contact::Coordinates: p(y, v) = C exp Q(rho, v) / (rho^2/2); an atom
  contact
};
inline constexpr base::EnumEntry<Variables> kVariablesNames[] = {
    {Variables::plane, "x1,x2"},
    {Variables::physical, "y,v"},
    {Variables::polar, "amplitude,phase"},
    {Variables::contact, "amplitude,velocity"}};
constexpr std::span<const base::EnumEntry<Variables>> names(Variables) { return kVariablesNames; }
constexpr std::string_view name(Variables variables) { return base::name_of(variables); }

/// Box outside of which the density is 0.
struct Box {
  double y_max, v_max;
  double y_min = 0;
};

/// Parameters of a density C exp(Q_n + confinement) besides the coefficients of Q_n.
struct Frame {
  Variables variables = Variables::plane;
  /// Position of y and v of Q_n on the physical axes: x and x' of problem/frame.hpp.
  problem::Frame coordinates = {};
  /// ln C; empty for a density that was not normalised.
  std::optional<double> log_constant = {};
  /// Plane: the density is 0 outside gaussian::Support, which these deviations scale.
  std::optional<Deviations> deviations = {};
  /// Other coordinates: the density is 0 beyond the contour of this energy.
  double support = std::numeric_limits<double>::infinity();
  /// Other coordinates: level of half_plane::Confinement, infinite without confinement.
  double level = std::numeric_limits<double>::infinity();
  /// Without deviations and energy: the density is 0 outside this box.
  std::optional<Box> box = {};
};

/// Density of a closure as stored in files; with the problem it can be evaluated again.
struct ClosedForm {
  Polynomial q;
  Frame frame;
};

/// Whether metrics, from epc/summary.hpp or a file written by hand, contain a closed form.
bool has_closed_form(const transform::Metrics& metrics);

/// Reads a closed form. Keys: `coordinates`, `coefficients[k].{x1,x2,a}`, `log_C` or `C`, and
///  - for the support: `support.{sigma1,sigma2}`, `support.energy` with `tail.{kind,level}`, or
///    `support.{y_max,v_max}` with `support.y_min` if that is not 0;
///  - `frame.{origin,mirrored}` if the coordinates are not the physical ones.
/// @throws InputError on one line: the missing or invalid key, without the file's name
ClosedForm read_closed_form(const transform::Metrics& metrics);

}  // namespace fpkcheck::epc
