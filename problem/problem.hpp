#pragma once

#include <string>

#include "problem/impulse_train.hpp"
#include "problem/system.hpp"

namespace fpkcheck::problem {

/// One stationary problem: an oscillator and its excitation.
struct Problem {
  std::string name;  ///< the case's name, used in reports
  System system;
  ImpulseTrain impulses;
};

}  // namespace fpkcheck::problem
