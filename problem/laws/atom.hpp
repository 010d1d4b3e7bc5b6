#pragma once

namespace fpkcheck::problem {

/// An atom of an amplitude law: an amplitude with positive probability, and this probability.
struct AmplitudeAtom {
  double amplitude;
  double probability;
};

}  // namespace fpkcheck::problem
