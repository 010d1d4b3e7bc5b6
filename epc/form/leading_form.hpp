#pragma once

#include <string>

#include "epc/form/polynomial.hpp"
#include "epc/form/rays.hpp"

namespace fpkcheck::epc {

/// Condition (19) of the paper: sign of the highest significant power of Q_n along each direction.
struct LeadingForm {
  bool negative;          ///< Q_n falls to minus infinity in every direction
  Direction worst;        ///< direction with the largest leading coefficient
  double rises_from = 0;  ///< scaled radius, at most 60, beyond which Q_n rises in this direction
  double rising_fraction = 0;  ///< fraction of all directions in which Q_n rises at infinity
};

/// Set of directions.
enum class Plane { whole, half };  ///< half: cos theta >= 0 only

LeadingForm leading_form(const Polynomial& q, const Deviations& sigma, Plane plane = Plane::whole);

/// Behaviour of Q_n at infinity as the end of a sentence: "although Q_n falls at infinity".
/// @param plane name of the coordinates of the scaled plane, e.g. "(y, v) / deviations"
std::string leading_form_text(const LeadingForm& form, const std::string& plane);

}  // namespace fpkcheck::epc
