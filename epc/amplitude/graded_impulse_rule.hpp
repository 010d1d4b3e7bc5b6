#pragma once

#include <vector>

#include "problem/impulse_law.hpp"

namespace fpkcheck::epc::amplitude {

/// Velocities after an impulse and their probabilities.
struct PostImpulseVelocities {
  std::vector<double> v, probability;
};

/// Quadrature rule for E[f(v + Y)]: a sum over `v` weighted by `probability`. The functions f are
/// smooth on either side of velocity 0 and vary near 0 over a width; rho and theta at a given y
/// have the width w(y). Atoms are exact. A density uses Gauss-Legendre panels between its break
/// points, graded towards velocity 0.
class GradedImpulseRule {
 public:
  explicit GradedImpulseRule(const problem::ImpulseLaw& law);

  /// The result is valid until the next call.
  /// @param width 0 for f that is smooth up to velocity 0 on either side
  const PostImpulseVelocities& operator()(double v, double width);

 private:
  void add_panel(double from, double to, double v);

  const problem::ImpulseLaw& law_;
  std::vector<double> pieces_;
  std::vector<problem::Atom> atoms_;
  std::vector<double> breaks_;
  PostImpulseVelocities after_;
};

}  // namespace fpkcheck::epc::amplitude
