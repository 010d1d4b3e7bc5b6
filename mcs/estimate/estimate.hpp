#pragma once

namespace fpkcheck::mcs {

/// Half-width of the 95 % interval of a normal variable, in standard errors.
inline constexpr double kNormal95 = 1.959964;

/// A mean and its standard error.
struct Estimate {
  double mean = 0;
  double standard_error = 0;
};

/// Quantile: `value` with the given probability below.
struct Quantile {
  double probability;
  double value;
  double lower, upper;  ///< ends of the 95 % interval
};

/// Rate of crossings of `level`, or of peaks above `level`, per unit time.
struct LevelRate {
  double level;
  Estimate rate;
};

}  // namespace fpkcheck::mcs
