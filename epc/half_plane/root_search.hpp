#pragma once

#include <complex>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "epc/half_plane/closure_density.hpp"
#include "epc/half_plane/galerkin_system.hpp"
#include "epc/half_plane/half_plane_basis.hpp"
#include "epc/options.hpp"
#include "numerics/roots/newton.hpp"

namespace fpkcheck::epc::half_plane {

/// Root of the closure equations of the requested order, or the reason why the search failed.
struct ClosureRootSearchResult {
  ClosureDensity closure;
  /// Closure density of order n - 2, below the requested order n; empty for n = 2.
  std::optional<ClosureDensity> previous;
  double decay_ratio = 0;
  QuadraturePointCounts quadrature{};
  /// Standard deviation of the change of the exponent Q_n when quadrature points are added.
  double quadrature_change = 0;
  /// Whether no quadrature points were added to check the root, as the density has by far not
  /// decayed.
  bool is_refinement_omitted = false;
  /// Result of Newton's method at the requested closure order, or at the order of failure, with the
  /// number of iterations of all orders.
  numerics::NewtonResult newton;
  double condition = 0;
  /// Eigenvalue with the largest real part of the linearised moment equations at the root
  std::complex<double> rightmost_eigenvalue = {};
  double relaxation_rate_unit = 0;  ///< ClosureFormulation::relaxation_rate_unit()
  int homotopies = 0;   ///< number of homotopies followed after damped Newton steps failed
  std::string failure;  ///< reason why no root was found; empty with a root
};

/// Stage of the search for a root of a closure, which sets the tolerance of Newton's method.
enum class ClosureRootSearchStage {
  rough,  ///< intermediate order, whose root starts the search at the next order
  last    ///< stage at the requested order
};

/// Condition under which the search for a root accepts the number of quadrature points.
struct QuadratureRefinementCriterion {
  /// Method to determine how much the exponent Q_n changes when quadrature points are added.
  enum class ChangeMeasure {
    solved,    ///< solve the equations again with additional points, and use the new root
    estimated  ///< estimate the change by one Newton step with additional points, and keep the root
  };
  ChangeMeasure rule;
  double tolerance;  ///< tolerance on the standard deviation of the change of the exponent Q_n
};

/// Interface of a formulation of the closure to the root search: coordinates, closure equations,
/// and candidates for the confinement level. All energies of a closure formulation have the
/// definition of QuadraturePoints::energy.
class ClosureFormulation {
 public:
  virtual ~ClosureFormulation() = default;

  /// Initial guess of the density at the lowest closure order n of the root search.
  virtual ClosureDensity initial_density() const = 0;
  /// Lowest closure order n that the root search solves before higher orders.
  virtual int lowest_searched_order(int /*order*/) const { return 2; }
  /// Whether the root search at closure order n may start from initial_density() if the start from
  /// the closure of order n-2 finds no root.
  virtual bool can_start_at_any_order() const { return false; }
  /// Unit of the residuals of the moment equations, half_plane::relaxation_rate_unit().
  virtual double relaxation_rate_unit() const = 0;
  /// Candidates for the confinement level, as energies, in the order of the attempts.
  virtual std::vector<double> candidate_confinement_energies(
      const ClosureDensity& guess, ClosureRootSearchStage stage) const = 0;
  /// Larger confinement level that suits the density of a root better than the level with which the
  /// root was found. If no better confinement level exists, the result is empty.
  virtual std::optional<double> improved_confinement_level(
      const ClosureDensity& /*guess*/, const ClosureDensity& /*closure*/) const {
    return std::nullopt;
  }

  /// @param level_over_temperature confinement level relative to E[v^2] of the initial guess
  virtual QuadraturePointCounts quadrature_point_counts(int order, double level_over_temperature,
                                                        ClosureRootSearchStage stage) const = 0;
  virtual QuadratureRefinementCriterion quadrature_refinement_criterion() const = 0;
  virtual QuadraturePoints quadrature_points_below_energy(
      double support, const QuadraturePointCounts& size) const = 0;
  virtual ClosureEquations closure_equations(double support,
                                             const ExponentConfinementTerm& confinement,
                                             OrthonormalBasis basis, QuadraturePoints points,
                                             const QuadraturePointCounts& size) const = 0;

  /// Exponent of the initial guess. A closure formulation may replace the polynomial Q_n of the
  /// initial guess of the density where this polynomial rises again.
  virtual double exponent_of_initial_guess(const ClosureDensity& guess, double s, double t) const {
    return guess.q(s, t);
  }
  /// Largest value of the first coordinate s up to which a polynomial Q_n falls
  /// (ClosureDensity::end_of_exponent_decay).
  virtual double end_of_exponent_decay(const ExponentPolynomial& /*q*/,
                                       double /*temperature*/) const {
    return std::numeric_limits<double>::infinity();
  }
  /// Weight of each quadrature point in the fit of the exponent Q_n to the initial guess.
  /// @param exponent exponent of the initial guess at the points
  /// @param mass probability of the initial guess at the points
  virtual Eigen::VectorXd weights_of_exponent_fit(const ClosureDensity& /*guess*/,
                                                  double /*support*/,
                                                  const QuadraturePoints& /*points*/,
                                                  const Eigen::VectorXd& /*exponent*/,
                                                  const Eigen::VectorXd& mass) const {
    return mass;
  }

  /// Largest density where the closure density should be negligible, relative to the peak.
  virtual double decay_ratio(const ClosureDensity& closure, ClosureRootSearchStage stage) const = 0;
  /// Largest decay ratio with which the search for a root accepts a confinement level.
  virtual double max_decay_ratio(ClosureRootSearchStage stage) const = 0;
};

/// Searches for the root of the closure equations of the requested order by solving the equations
/// of all even orders in turn. The root search at closure order n starts from the density of
/// closure order n - 2, on a domain adapted to the density of order n - 2. If the start from
/// closure order n - 2 fails, formulations with can_start_at_any_order() restart from the initial
/// density. The root search at each closure order uses the first confinement level at which the
/// density has decayed, or else the level with the smallest decay ratio. At the requested closure
/// order the number of quadrature points grows until more points do not change the root.
ClosureRootSearchResult find_closure_root(const ClosureFormulation& formulation,
                                          const ClosureOptions& options);

}  // namespace fpkcheck::epc::half_plane
