#pragma once

#include "mcs/motion/general_oscillator.hpp"
#include "mcs/options.hpp"
#include "problem/frame.hpp"
#include "problem/problem.hpp"
#include "problem/scales.hpp"

namespace fpkcheck::mcs {

/// What the plan has besides of an oscillator that is not the paper's.
struct GeneralPlan {
  problem::Scales scales;
  GeneralOscillator oscillator;
  GeneralKicks kicks;
  double power;  ///< D + lambda E[Y^2]/2, what noise and impulses bring
  bool rests;    ///< the law has atoms of rest in contact
  int wells;     ///< Features::wells
};

/// @throws InputError where the options ask for what such an oscillator does not have
GeneralPlan make_general_plan(const problem::Problem& problem, const Options& options);

}  // namespace fpkcheck::mcs
