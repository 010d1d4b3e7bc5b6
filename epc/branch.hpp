#pragma once

#include <vector>

namespace fpkcheck::epc {

/// A point of the branch of solutions that starts from the exact density of white noise at an
/// impact without loss, and on which 1-r, E[Y], E[Y^3], E[Y^4] and, for `kf`, the rest of the jump
/// integral grow with the fraction. The full problem is at fraction 1.
struct BranchPoint {
  double fraction;
  double norm;                     ///< of the coefficients in the scaled basis
  double smallest_singular_value;  ///< of the Jacobian there; zero at a fold
  int determinant_sign;            ///< of the Jacobian; changes at a fold
  bool falls;                      ///< Q_n falls in every direction, paper (19)
  bool fold;                       ///< the fraction turns round here
};

/// How the branch was left.
enum class BranchEnd {
  not_followed,  ///< a root had been found otherwise
  full_problem,  ///< it reaches fraction 1
  white_noise,   ///< it comes back to fraction 0, at another root of the equations of white noise
  far_away,      ///< the coefficients grow beyond all measure
  lost           ///< the steps shrank to nothing, or the allowed points were spent
};

struct Branch {
  BranchEnd end = BranchEnd::not_followed;
  double furthest = 0;              ///< greatest fraction
  std::vector<BranchPoint> points;  ///< in the order of its length
};

}  // namespace fpkcheck::epc
