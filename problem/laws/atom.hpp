#pragma once

namespace fpkcheck::problem {

/// A value that an impulse amplitude takes with a positive probability.
struct Atom {
  double amplitude;
  double probability;
};

}  // namespace fpkcheck::problem
