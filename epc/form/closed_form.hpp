#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string_view>

#include "base/options/names.hpp"
#include "epc/form/polynomial.hpp"
#include "epc/form/rays.hpp"
#include "problem/frame.hpp"
#include "transform/observation.hpp"

namespace fpkcheck::epc {

/// What Q_n is a polynomial of.
enum class Variables {
  plane,     ///< z and z' of Zhuravlev's plane: p(y, v) = C (exp Q(y, v) + exp Q(-y, -v))
  physical,  ///< y and v: p(y, v) = C exp Q(y, v)
  polar,     ///< amplitude and phase, polar::Coordinates: p(y, v) = C exp Q(rho, theta)
  /// Amplitude and velocity, contact::Coordinates: p(y, v) = C exp Q(rho, v) / (rho^2/2), and an atom
  contact
};
inline constexpr base::Named<Variables> kVariablesNames[] = {
    {Variables::plane, "x1,x2"},
    {Variables::physical, "y,v"},
    {Variables::polar, "amplitude,phase"},
    {Variables::contact, "amplitude,velocity"}};
constexpr std::span<const base::Named<Variables>> names(Variables) { return kVariablesNames; }
constexpr std::string_view name(Variables variables) { return base::name_of(variables); }

/// A box around what counts as the density.
struct Box {
  double y_max, v_max;
  double y_min = 0;
};

/// All of a density C exp(Q_n + confinement) but the coefficients of Q_n.
struct Frame {
  Variables variables = Variables::plane;
  /// Where y and v of Q_n lie on the physical axes: x and x' of problem/frame.hpp.
  problem::Frame coordinates = {};
  /// ln C; nothing where nobody normalised it.
  std::optional<double> log_constant = {};
  /// Of the plane: the density is 0 outside gaussian::Support, which these deviations scale.
  std::optional<Deviations> deviations = {};
  /// Otherwise: it is 0 beyond the contour of this energy.
  double support = std::numeric_limits<double>::infinity();
  /// Otherwise: that of half_plane::Confinement, infinite where there is none.
  double level = std::numeric_limits<double>::infinity();
  /// Of one that has neither: it is 0 outside.
  std::optional<Box> box = {};
};

/// A closure's density as files keep it: with the problem it can be evaluated again.
struct ClosedForm {
  Polynomial q;
  Frame frame;
};

/// Whether files that were observed (epc/summary.hpp) or written by hand hold one.
bool has_closed_form(const transform::Observations& observations);

/// Reads one back: `coordinates`, `coefficients[k].{x1,x2,a}`, `log_C` or `C`, and of the support
/// `support.{sigma1,sigma2}`, `support.energy` with `tail.{kind,level}`, or
/// `support.{y_max,v_max}` with `support.y_min` where that is not 0; `frame.{origin,mirrored}`
/// where the coordinates are not the physical ones.
/// @throws InputError on one line: what is missing or out of range, without the file's name
ClosedForm closed_form_in(const transform::Observations& observations);

}  // namespace fpkcheck::epc
