#pragma once

namespace fpkcheck::problem {

/// An impulse amplitude that has a positive probability.
struct Atom {
  double amplitude;
  double probability;
};

}  // namespace fpkcheck::problem
