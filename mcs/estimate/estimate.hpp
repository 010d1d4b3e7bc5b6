#pragma once

namespace fpkcheck::mcs {

/// Half the width of a 95 % interval of a normal variable, in standard errors.
inline constexpr double kNormal95 = 1.959964;

/// A mean and its standard error.
struct Estimate {
  double mean = 0;
  double standard_error = 0;
};

/// Where the probability below reaches a given one.
struct Quantile {
  double probability;
  double value;
  double lower, upper;  ///< ends of the 95 % interval
};

/// A rate of passing a level of y, per unit time.
struct LevelRate {
  double level;
  Estimate rate;
};

}  // namespace fpkcheck::mcs
