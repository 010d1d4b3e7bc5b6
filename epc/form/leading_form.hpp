#pragma once

#include <string>

#include "epc/form/polynomial.hpp"
#include "epc/form/rays.hpp"

namespace fpkcheck::epc {

/// Behaviour of Q_n at infinity, by condition (19) of the paper: sign of the highest significant
/// power of Q_n along each direction.
struct LeadingForm {
  bool negative;    ///< whether Q_n falls to minus infinity in every direction
  Direction worst;  ///< direction with the largest leading coefficient
  /// scaled radius, at most 60, beyond which Q_n rises in the worst direction
  double rises_from = 0;
  double rising_fraction = 0;  ///< fraction of all directions in which Q_n rises at infinity
};

/// Set of directions in which Q_n is examined: the whole plane, or the half-plane cos theta >= 0.
enum class DirectionSet { whole, half };

/// Determines the behaviour of Q_n at infinity in all directions of a set.
/// @param sigma standard deviations that scale the plane
LeadingForm leading_form(const Polynomial& q, const StandardDeviations& sigma,
                         DirectionSet plane = DirectionSet::whole);

/// Clause that describes the behaviour of Q_n at infinity and ends a sentence, such as "although
/// Q_n falls at infinity".
/// @param plane name of the coordinates of the scaled plane, e.g. "(y, v) / deviations"
std::string leading_form_text(const LeadingForm& form, const std::string& plane);

}  // namespace fpkcheck::epc
