#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "epc/half_plane/basis.hpp"
#include "epc/half_plane/closure_density.hpp"
#include "epc/half_plane/galerkin_system.hpp"
#include "epc/options.hpp"
#include "numerics/roots/newton.hpp"

namespace fpkcheck::epc::half_plane {

/// Result of the search for a root.
struct RootSearchResult {
  ClosureDensity closure;
  /// Density of order n - 2, solved with a larger tolerance; empty for n = 2.
  std::optional<ClosureDensity> previous;
  /// Largest density in the region where the density should have decayed, relative to the peak, by
  /// ClosureFormulation::decay_ratio.
  double decay_ratio = 0;
  QuadratureSize quadrature{};
  /// Estimated quadrature error: standard deviation of the change of Q_n on more points.
  double quadrature_change = 0;
  /// Result of Newton's method at the requested order, or at the order that failed. The number of
  /// iterations is the sum over all orders.
  numerics::NewtonResult newton;
  double condition = 0;  ///< condition number of the Jacobian at the root, by condition_number()
  int homotopies = 0;    ///< number of homotopies followed after damped Newton steps failed
  std::string failure;   ///< reason why no root was found, one sentence; else empty
};

/// Stage of the search, which sets the accuracy of the solution at an order.
enum class SearchStage {
  rough,  ///< an intermediate order, whose root is the start of the next order
  last    ///< the requested order
};

/// Criterion by which the search increases the number of quadrature points.
struct QuadratureRefinement {
  /// How the search determines the change of Q_n on more quadrature points.
  enum class ChangeMeasure {
    solved,    ///< solve the equations again on more points and use the new root
    estimated  ///< estimate the change by one Newton step on more points and keep the root
  };
  ChangeMeasure rule;
  double tolerance;  ///< tolerance on the standard deviation of the change of Q_n
};

/// Interface between a formulation of the closure and the search for a root: coordinates,
/// equations, and candidates for the confinement level. The energies are the energies of
/// QuadraturePoints.
class ClosureFormulation {
 public:
  virtual ~ClosureFormulation() = default;

  /// Density from which the first order starts.
  virtual ClosureDensity initial_density() const = 0;
  /// Lowest order that the search solves before the requested order.
  virtual int first_order(int /*order*/) const { return 2; }
  /// Whether an order may start from initial_density() if the search from the next lower order
  /// finds no root.
  virtual bool can_start_at_any_order() const { return false; }
  /// Unit in which rates of change are measured.
  virtual double rate_of_change_unit() const = 0;
  /// Candidates for the confinement level, as energies, in the order of the attempts.
  virtual std::vector<double> confinement_levels(const ClosureDensity& guess,
                                                 SearchStage stage) const = 0;
  /// Confinement level that is larger than the level of a root's density and suits this density
  /// better; empty if there is no such level.
  virtual std::optional<double> improved_confinement_level(
      const ClosureDensity& /*guess*/, const ClosureDensity& /*closure*/) const {
    return std::nullopt;
  }

  /// Number of quadrature points for the first attempt.
  /// @param level_over_temperature confinement level divided by the temperature of the guess
  virtual QuadratureSize quadrature_size(int order, double level_over_temperature,
                                         SearchStage stage) const = 0;
  /// Criterion by which the search increases the number of quadrature points.
  virtual QuadratureRefinement quadrature_refinement() const = 0;
  /// Quadrature points on the part of the half-plane where the energy is below `support`.
  virtual QuadraturePoints points_below_energy(double support,
                                               const QuadratureSize& size) const = 0;
  /// Galerkin equations for a basis on given quadrature points.
  virtual ClosureEquations closure_equations(double support, const Confinement& confinement,
                                             Basis basis, QuadraturePoints points,
                                             const QuadratureSize& size) const = 0;

  /// Exponent of the density from which an order starts, the guess. Where the Q_n of the guess
  /// rises again, the exponent may differ from Q_n.
  virtual double exponent_of_guess(const ClosureDensity& guess, double s, double t) const {
    return guess.q(s, t);
  }
  /// ClosureDensity::decay_extent for a polynomial Q_n: the largest s up to which Q_n falls.
  virtual double decay_extent(const Polynomial& /*q*/, double /*temperature*/) const {
    return std::numeric_limits<double>::infinity();
  }
  /// Weight of each quadrature point in the fit of Q_n to the exponent of a guess.
  /// @param exponent exponent of the guess at the points
  /// @param mass probability of the guess with its confinement at the points
  virtual Eigen::VectorXd fit_weights(const ClosureDensity& /*guess*/, double /*support*/,
                                      const QuadraturePoints& /*points*/,
                                      const Eigen::VectorXd& /*exponent*/,
                                      const Eigen::VectorXd& mass) const {
    return mass;
  }

  /// Largest density in the region where the density should have decayed, relative to the peak.
  virtual double decay_ratio(const ClosureDensity& closure, SearchStage stage) const = 0;
  /// Limit on the decay ratio: below this limit the search tries no other confinement level.
  virtual double decay_ratio_limit(SearchStage stage) const = 0;
};

/// Searches for the root of the requested order. The search solves the even orders in turn. Each
/// order starts from the density of order n - 2, on a domain adapted to that density. If an order
/// has no root from this start, formulations with can_start_at_any_order() restart from the first
/// density. Each order uses the first confinement level at which the density has decayed, else the
/// level with the smallest decay ratio. At the requested order, the number of quadrature points is
/// increased until the quadrature resolves the root.
RootSearchResult find_root(const ClosureFormulation& formulation, const Options& options);

}  // namespace fpkcheck::epc::half_plane
