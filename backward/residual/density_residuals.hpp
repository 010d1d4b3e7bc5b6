#pragma once

#include <Eigen/Core>
#include <array>
#include <iterator>
#include <optional>
#include <span>

#include "backward/residual/judged_functions.hpp"
#include "backward/residual/unresolved.hpp"
#include "backward/residual/weak_residuals.hpp"
#include "problem/problem.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::backward {

inline constexpr std::size_t kMomentCount = std::size(transform::kMoments);

/// What is known of an error.
struct JudgedError {
  double found = 0;       ///< by dual-weighted residuals
  double unresolved = 0;  ///< Unresolved, of what the residuals were weighted by
  /// Half the sum of Unresolved::contrasts(): 0 where the residuals determine the shares of wells, 1
  /// where they do not depend on them.
  double contrast = 0;
};

/// A density's own errors, from itself and the problem alone.
struct WeightedResiduals {
  double mass;                   ///< of the density, by which all else is divided
  transform::Moments corrected;  ///< estimates of E[f]
  transform::Moments error;      ///< E_p[f] - corrected
  /// Where the errors come from: -(h_ij - E_p[h]) rho_ij of each of transform::kMoments, of shape
  /// (functions of y, functions of v). Their sum is the error.
  std::array<Eigen::MatrixXd, kMomentCount> contributions;

  std::array<double, kMomentCount> unresolved;  ///< of the moments, in their order
  std::array<double, kMomentCount> contrasts;   ///< likewise: Unresolved::contrasts()
  /// Of p(y) and p(y') in L1, over the bins of judged_functions().
  JudgedError y_l1, ydot_l1;

  /// What can be said: the errors as found, kNotSeen times those in L1 for features that are
  /// narrower than bins, and what is unresolved in proportion to the error itself, since
  /// (E_p - E)[e] is small where p is right. Nothing where that is 2 or more, the L1 distance of
  /// densities that have nothing in common: no estimate.
  std::optional<transform::StatedError> stated() const;

  /// Of 1389 errors of closures in random problems one in twenty was more than 1.3 times what was
  /// found, one in a hundred more than 1.5 times (docs/limits.md).
  static constexpr double kNotSeen = 1.6;
};

/// Dual-weighted residuals. Let h = sum h_ij A_i(y) B_j(v) solve L h = E[f] - f with h(0, r u) =
/// h(0, -u). For any density p of mass 1
///
///     E_p[f] - E[f] = -(int p L h dy dv + int u p(0, -u) [h(0, r u) - h(0, -u)] du)
///                   = -sum_ij h_ij rho_ij,
///
/// with the weak residuals rho_ij of p (WeakResiduals): no other density is needed to know the
/// error of this one. As the h here solves its equations but nearly (control_functions), what is
/// left is a product of two small things, its residuals and the error of p. A constant added to h
/// changes no sum; E_p[h] = 0 makes the parts comparable.
///
/// The error is that against the full problem, whatever p solves itself: of a solution of the
/// white-noise equation it is also the model's. Moments are those of the physical coordinates
/// (Problem::frame), all else is in the frame.
class DensityResiduals {
 public:
  static constexpr ControlCells kCells{.y = 40, .v = 88};
  /// Wells under noise are narrower than the range of y: with kCells bins see less than half of an
  /// error within them. In the time of kCells (docs/residuals.md).
  static constexpr ControlCells kCellsOfWells{.y = 80, .v = 64};
  /// Between two wells solutions of the backward equation bend sharply along the orbits that end on
  /// top of the barrier, unless noise smoothes them.
  static constexpr ControlCells kCellsOfSharpWells{.y = 56, .v = 112};

  /// Takes most of the time: the fit of h.
  /// @param problem in its frame, as the densities that are to be judged; residuals_refused() is empty
  /// @throws FitBrokeDown (backward/generator/normal_equations.hpp)
  explicit DensityResiduals(const problem::Problem& problem);
  DensityResiduals(const problem::Problem& problem, const ControlCells& cells);

  /// @throws InputError when the density has no positive mass, or no usable cells or range
  WeightedResiduals of(const transform::Density& density) const;

  /// Spreads contributions over rectilinear cells:
  ///
  ///     sum_ij contribution_ij (int_cell A_i B_j dy dv / int A_i B_j dy dv) / area,
  ///
  /// so that the values times the areas sum to the error when the cells cover the splines.
  /// @param y_edges, v_edges increasing
  /// @return shape (cells of y, cells of v)
  /// @throws InputError when edges do not increase
  Eigen::MatrixXd spread(const Eigen::MatrixXd& contributions, std::span<const double> y_edges,
                         std::span<const double> v_edges) const;

  const numerics::KnotSplines& y() const { return residuals_.y(); }
  const numerics::KnotSplines& v() const { return residuals_.v(); }

 private:
  /// The coefficients h_ij of one function.
  Eigen::MatrixXd coefficients(Eigen::Index function) const;

  WeakResiduals residuals_;
  JudgedFunctions functions_;
  ControlFunctions h_;
  Unresolved unresolved_;
};

}  // namespace fpkcheck::backward
