#pragma once

#include "mcs/motion/general_oscillator.hpp"
#include "mcs/options.hpp"
#include "problem/frame.hpp"
#include "problem/problem.hpp"
#include "problem/scales.hpp"

namespace fpkcheck::mcs {

/// Additional members of a simulation plan for an oscillator outside the paper's class.
struct GeneralPlan {
  problem::MotionScales scales;
  GeneralOscillator oscillator;
  NoiseKicks kicks;
  double power;            ///< D + lambda E[Y^2]/2, mean power of noise and impulses
  bool has_contact_atoms;  ///< the stationary law has atoms at rest in contact
  int wells;               ///< number of potential wells, ProblemFeatures::wells
};

/// @throws InputError for options without support outside the paper's class
GeneralPlan make_general_plan(const problem::Problem& problem, const Options& options);

}  // namespace fpkcheck::mcs
