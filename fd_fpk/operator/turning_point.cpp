#include "fd_fpk/operator/turning_point.hpp"

namespace fpkcheck::fd_fpk {

double turning_point(const problem::System& system, double energy) {
  const auto& potential = system.potential();
  double below = 0, above = 1;
  while (potential(above) < energy) above *= 2;
  // Bisection, until no number is left between the two.
  while (true) {
    const double middle = (below + above) / 2;
    if (middle <= below || middle >= above) return above;
    (potential(middle) < energy ? below : above) = middle;
  }
}

}  // namespace fpkcheck::fd_fpk
