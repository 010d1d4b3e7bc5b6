#pragma once

#include <vector>

#include "problem/impulse_law.hpp"

namespace fpkcheck::epc::amplitude {

/// Velocities after an impulse, and how probable each is.
struct AfterImpulse {
  std::vector<double> v, probability;
};

/// E[f(v + Y)] as a sum over `v` weighted by `probability`, for functions f of a velocity that are
/// smooth on both sides of 0 and change there over a width: rho and theta at a given y do, with the
/// width w(y). Atoms are taken as they are; a density by Gauss-Legendre panels between its own
/// break points that narrow towards velocity 0.
class GradedImpulseRule {
 public:
  explicit GradedImpulseRule(const problem::ImpulseLaw& law);

  /// The result is valid until the next call.
  /// @param width 0 where f is smooth up to velocity 0 on either side
  const AfterImpulse& operator()(double v, double width);

 private:
  void add_panel(double from, double to, double v);

  const problem::ImpulseLaw& law_;
  std::vector<double> pieces_;
  std::vector<problem::Atom> atoms_;
  std::vector<double> breaks_;
  AfterImpulse after_;
};

}  // namespace fpkcheck::epc::amplitude
