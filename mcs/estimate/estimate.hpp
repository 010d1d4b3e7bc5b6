#pragma once

namespace fpkcheck::mcs {

/// Half-width of the 95 % interval of a normal variable, in standard errors.
inline constexpr double kNormal95 = 1.959964;

/// A mean and its standard error.
struct Estimate {
  double mean = 0;
  double standard_error = 0;
};

/// Quantile of a variable: the probability of a smaller value than `value` is `probability`.
struct Quantile {
  double probability;
  double value;
  double lower, upper;  ///< ends of the 95 % interval
};

/// Rate of upward crossings of the level of y, or of peaks above this level, per unit time.
struct LevelEventRate {
  double level;
  Estimate rate;
};

}  // namespace fpkcheck::mcs
