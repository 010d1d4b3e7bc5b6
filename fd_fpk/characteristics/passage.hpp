#pragma once

#include <Eigen/Core>
#include <array>

#include "fd_fpk/characteristics/characteristics.hpp"
#include "fd_fpk/characteristics/tilts.hpp"

namespace fpkcheck::fd_fpk {

/// Impacts per impulse, at one wall.
struct ImpactSums {
  double number = 0;  ///< those of a cascade to rest, of which there are infinitely many, left out
  double momentum = 0;  ///< of the speeds
  double energy = 0;    ///< of their cubes over the speed, v^2: what int |v|^3 p dv sums
};
struct WallImpacts {
  ImpactSums left, right;
  ImpactSums& at(Side side) { return side == Side::left ? left : right; }
};

/// Where the oscillator is when the next impulse comes, given where the last one took it: p, the
/// density between impulses, from q, that after an impulse,
///
///     p = lambda int_0^infinity exp(-lambda t) (q carried along the motion for t) dt.
///
/// Each visit of a characteristic takes its share of what starts in its cell, with its tilt, adds it
/// to what comes from the visit before, and passes on what no impulse has ended. Exact along the
/// characteristics; the mass is kept.
///
/// Both are masses on the cells, and after them of each place of contact: of p what rests there, of q
/// what an impulse has just taken from there.
class Passage {
 public:
  /// They must outlive it.
  Passage(const Characteristics& characteristics, const problem::ImpulseLaw& law)
      : characteristics_(characteristics), emissions_(characteristics.emissions(law)) {}

  /// @param masses of q; tilts of q
  Eigen::VectorXd operator()(const Eigen::VectorXd& masses, const Tilts& tilts,
                             WallImpacts* impacts = nullptr) const;

 private:
  const Characteristics& characteristics_;
  std::vector<Emission> emissions_;
};

}  // namespace fpkcheck::fd_fpk
