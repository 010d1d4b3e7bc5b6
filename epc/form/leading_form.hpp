#pragma once

#include <string>

#include "epc/form/polynomial.hpp"
#include "epc/form/rays.hpp"

namespace fpkcheck::epc {

/// Condition (19) of the paper, read off the highest power of Q_n that counts along each direction.
struct LeadingForm {
  bool negative;            ///< Q_n falls to minus infinity in every direction
  Direction worst;          ///< where the leading coefficient is largest
  double rises_from = 0;    ///< radius in the scaled plane, at most 60, from which Q_n rises there
  double rising_share = 0;  ///< share of all directions in which Q_n rises in the end
};

/// Where directions are looked at.
enum class Plane { whole, half };  ///< half: cos theta >= 0 only

LeadingForm leading_form(const Polynomial& q, const Deviations& sigma, Plane plane = Plane::whole);

/// What Q_n does at infinity, as the end of a sentence: "though Q_n falls in the end".
/// @param plane how the coordinates of the scaled plane are called, e.g. "(y, v) / deviations"
std::string behaviour(const LeadingForm& form, const std::string& plane);

}  // namespace fpkcheck::epc
