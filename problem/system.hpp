#pragma once

namespace fpkcheck::problem {

/// Coefficients of the oscillator, as read from a case file. All quantities are non-dimensional,
/// here and everywhere in the project.
struct SystemCoefficients {
  double damping;      ///< c > 0
  double stiffness;    ///< k >= 0, and k > 0 when mu = 0
  double cubic;        ///< mu >= 0
  double restitution;  ///< r, 0 < r <= 1
};

/// The vibro-impact Duffing oscillator, paper (1)-(2):
///
///     y'' + c y' + k y + mu y^3 = xi(t)  for y > 0,      y'(+) = -r y'(-)  at y = 0.
class System {
 public:
  /// @throws InputError naming the coefficient, its value and the allowed range
  explicit System(const SystemCoefficients& coefficients);

  double damping() const { return c_.damping; }
  double stiffness() const { return c_.stiffness; }
  double cubic() const { return c_.cubic; }
  double restitution() const { return c_.restitution; }

  /// Restoring force k y + mu y^3.
  double restoring_force(double y) const { return y * (c_.stiffness + c_.cubic * y * y); }

 private:
  SystemCoefficients c_;
};

}  // namespace fpkcheck::problem
