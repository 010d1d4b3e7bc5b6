#pragma once

#include <limits>
#include <optional>
#include <string_view>

#include "base/options/enum_names.hpp"
#include "epc/form/polynomial.hpp"
#include "problem/walls.hpp"
#include "transform/metric.hpp"

namespace fpkcheck::epc {

/// Coordinates of the polynomial Q_n.
enum class ExponentCoordinates {
  /// z and z', the coordinates of Zhuravlev's plane: p(y, v) = C (exp Q(y, v) + exp Q(-y, -v))
  plane,
  physical,  ///< y and v: p(y, v) = C exp Q(y, v)
  polar,     ///< amplitude and phase, polar::Coordinates: p(y, v) = C exp Q(rho, theta)
  /// amplitude and velocity, contact::Coordinates: p(y, v) = C exp Q(rho, v) / (rho^2/2), and an
  /// atom at y = v = 0
  contact
};
inline constexpr base::EnumEntry<ExponentCoordinates> kExponentCoordinatesNames[] = {
    {ExponentCoordinates::plane, "x1,x2"},
    {ExponentCoordinates::physical, "y,v"},
    {ExponentCoordinates::polar, "amplitude,phase"},
    {ExponentCoordinates::contact, "amplitude,velocity"}};
constexpr const auto& enumerator_names(ExponentCoordinates) { return kExponentCoordinatesNames; }
constexpr std::string_view name(ExponentCoordinates variables) { return base::name_of(variables); }

/// Bounding box in the (y, v) plane outside of which the density is 0.
struct BoundingBox {
  double y_max, v_max;
  double y_min = 0;
};

/// All parameters of a density C exp(Q_n + confinement) except the coefficients of Q_n.
struct ClosedFormParameters {
  ExponentCoordinates variables = ExponentCoordinates::plane;
  /// Origin and direction, on the physical axes, of the coordinates y and v of Q_n. They are x and
  /// x' of problem/walls.hpp.
  problem::Frame coordinates = {};
  /// ln C, the logarithm of the constant factor; empty for a density that was not normalised.
  std::optional<double> log_constant = {};
  /// Standard deviations that scale gaussian::DensitySupport, outside of which the density is 0;
  /// empty if the density has another support.
  std::optional<StandardDeviations> deviations = {};
  /// Energy beyond whose contour the density is 0; used unless Q_n has the coordinates `plane`.
  double support = std::numeric_limits<double>::infinity();
  /// Level of half_plane::Confinement, infinite without confinement; used unless Q_n has the
  /// coordinates `plane`.
  double level = std::numeric_limits<double>::infinity();
  /// Bounding box outside of which the density is 0; used if there are neither deviations nor an
  /// energy.
  std::optional<BoundingBox> box = {};
};

/// Density of a closure as files store the density: exponent and parameters. Some forms also need
/// the problem for an evaluation.
struct ClosedForm {
  Polynomial q;
  ClosedFormParameters frame;
};

/// Whether metrics contain a closed form. The metrics come from epc/summary.hpp or from a file of
/// the user.
bool has_closed_form(const transform::Metrics& metrics);

/// Reads a closed form from metrics. The keys are `coordinates`, `coefficients[k].{x1,x2,a}`,
/// `log_C` or `C`, and
///  - for the support: `support.{sigma1,sigma2}`, `support.energy` with `tail.{kind,level}`, or
///    `support.{y_max,v_max}`, with `support.y_min` if y_min is not 0;
///  - `frame.{origin,mirrored}` if the coordinates are not the physical coordinates.
/// @throws InputError with a message of one line: the missing or invalid key, without the file name
ClosedForm read_closed_form(const transform::Metrics& metrics);

}  // namespace fpkcheck::epc
