#pragma once

#include <limits>
#include <optional>
#include <string_view>

#include "base/options/enum_names.hpp"
#include "epc/form/exponent_polynomial.hpp"
#include "problem/walls.hpp"
#include "transform/solver_metric.hpp"

namespace fpkcheck::epc {

/// Pair of variables of the polynomial Q_n in the exponent of a closure density C exp(Q_n).
enum class ExponentCoordinates {
  /// Coordinates z and z' of Zhuravlev's plane: p(y, v) = C (exp Q(y, v) + exp Q(-y, -v))
  plane,
  physical,  ///< coordinates y and v: p(y, v) = C exp Q(y, v)
  polar,  ///< amplitude and phase, polar::AmplitudePhaseCoordinates: p(y, v) = C exp Q(rho, theta)
  /// Amplitude and velocity of contact::AmplitudeVelocityCoordinates: the density is p(y, v) = C
  /// exp Q(rho, v) / (rho^2/2), with an atom at y = v = 0
  contact
};
inline constexpr base::EnumEntry<ExponentCoordinates> kExponentCoordinatesNames[] = {
    {ExponentCoordinates::plane, "x1,x2"},
    {ExponentCoordinates::physical, "y,v"},
    {ExponentCoordinates::polar, "amplitude,phase"},
    {ExponentCoordinates::contact, "amplitude,velocity"}};
constexpr const auto& enumerator_names(ExponentCoordinates) { return kExponentCoordinatesNames; }
constexpr std::string_view name(ExponentCoordinates variables) { return base::name_of(variables); }

/// Bounding box in the (y, v) plane outside of which a density is 0.
struct DensityBoundingBox {
  double y_max, v_max;
  double y_min = 0;
};

/// Parameters of a closure density C exp(Q_n + confinement term), without the coefficients of Q_n.
struct ClosedFormDensityParameters {
  ExponentCoordinates variables = ExponentCoordinates::plane;
  /// Origin and direction on the physical axes of the variables of Q_n (problem/walls.hpp).
  problem::WallFrame coordinates = {};
  /// Logarithm of the constant factor C of a closure density; empty without normalisation.
  std::optional<double> log_constant = {};
  /// Standard deviations that scale the support of the density (gaussian::DensitySupport); empty
  /// for other supports.
  std::optional<StandardDeviations> deviations = {};
  /// Energy above which the closure density is 0; unused on the (z, z') plane.
  double support = std::numeric_limits<double>::infinity();
  /// Confinement level (an energy) of half_plane::ExponentConfinementTerm, infinite without
  /// confinement; unused if Q_n is a polynomial on the (z, z') plane.
  double level = std::numeric_limits<double>::infinity();
  /// Bounding box outside of which the closure density is 0; used if `deviations` is empty and
  /// `support` is infinite.
  std::optional<DensityBoundingBox> box = {};
};

/// Formula of a closure density with all its parameters, as stored in files. For polynomials of
/// amplitude and phase or velocity, the density of a closed form also depends on the oscillator.
struct ClosedFormDensity {
  ExponentPolynomial q;
  ClosedFormDensityParameters frame;
};

/// Returns whether the metrics of a solution or of a user's file contain a closed form.
bool has_closed_form(const transform::Metrics& metrics);

/// Reads a closed form from metrics. The keys of a closed form are `coordinates`,
/// `coefficients[k].{x1,x2,a}`, `log_C` or `C`, and
///  - for the support: `support.{sigma1,sigma2}`, `support.energy` with `tail.{kind,level}`, or
///    `support.{y_max,v_max}`, with `support.y_min` if y_min is not 0;
///  - `frame.{origin,mirrored}` if the coordinates are not the physical coordinates.
/// @throws InputError that states the missing or invalid key, without the file name
ClosedFormDensity read_closed_form(const transform::Metrics& metrics);

}  // namespace fpkcheck::epc
