#pragma once

#include <Eigen/Core>

#include "fd_fpk/characteristics/characteristics.hpp"
#include "fd_fpk/characteristics/tilts.hpp"

namespace fpkcheck::fd_fpk {

/// Impacts per impulse.
struct ImpactSums {
  double number = 0;
  double momentum = 0;  ///< of the speeds
  double energy = 0;    ///< of their cubes over the speed, v^2: what int |v|^3 p dv sums
};

/// Where the oscillator is when the next impulse comes, given where the last one took it: p, the
/// density between impulses, from q, that after an impulse,
///
///     p = lambda int_0^infinity exp(-lambda t) (q carried along the motion for t) dt.
///
/// Each visit of a characteristic takes its share of what starts in its cell, with its tilt, adds it
/// to what comes from the visit before, and passes on what no impulse has ended. Exact along the
/// characteristics; the mass is kept.
class Passage {
 public:
  /// They must outlive it.
  explicit Passage(const Characteristics& characteristics) : characteristics_(characteristics) {}

  /// @param masses of q on the cells; tilts of q
  Eigen::VectorXd operator()(const Eigen::VectorXd& masses, const Tilts& tilts,
                             ImpactSums* impacts = nullptr) const;

 private:
  const Characteristics& characteristics_;
};

}  // namespace fpkcheck::fd_fpk
