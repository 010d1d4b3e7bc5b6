#pragma once

#include <optional>
#include <vector>

#include "epc/half_plane/confinement.hpp"
#include "epc/half_plane/equations.hpp"
#include "epc/half_plane/root.hpp"

namespace fpkcheck::epc::half_plane {

/// Accuracy with which an order is solved.
enum class SearchStage {
  rough,  ///< intermediate order, start of the next order
  last    ///< requested order
};

/// Criterion for the number of quadrature points.
struct Refinement {
  enum class Rule {
    /// Solve again on more points and use the new root.
    solved,
    /// Estimate the change by one Newton step on more points and keep the root.
    estimated
  };
  Rule rule;
  double tolerance;  ///< on the standard deviation of the change of Q_n
};

/// Formulation of the closure as the search for a root uses it: coordinates, equations, and
/// candidates for the confinement level of an exponent Q_n. Energies are those of QuadraturePoints.
class ClosureFormulation {
 public:
  virtual ~ClosureFormulation() = default;

  /// Density from which the first order starts.
  virtual ClosureDensity start() const = 0;
  /// First order to solve on the way to an order.
  virtual int first_order(int /*order*/) const { return 2; }
  /// Whether every order may start from start() if the order below leads to no root.
  virtual bool can_start_at_any_order() const { return false; }
  /// Unit of rates of change.
  virtual double rate_unit() const = 0;
  /// Energies for the confinement level, in the order of the attempts.
  virtual std::vector<double> confinement_levels(const ClosureDensity& guess,
                                                 SearchStage stage) const = 0;
  /// Larger confinement level that a root at the present level shows to be better; or empty.
  virtual std::optional<double> improved_level(const ClosureDensity& /*guess*/,
                                               const ClosureDensity& /*closure*/) const {
    return std::nullopt;
  }

  /// Number of points for the first attempt.
  /// @param level_over_temperature confinement level divided by the temperature of the guess
  virtual QuadratureSize size(int order, double level_over_temperature,
                              SearchStage stage) const = 0;
  virtual Refinement refinement() const = 0;
  /// Quadrature points on the part of the half-plane below an energy.
  virtual QuadraturePoints points(double support, const QuadratureSize& size) const = 0;
  /// Equations on these points.
  virtual Equations equations(double support, const Confinement& confinement, Basis basis,
                              QuadraturePoints points, const QuadratureSize& size) const = 0;

  /// Exponent of a guess, which may differ from Q_n where Q_n rises again.
  virtual double exponent(const ClosureDensity& guess, double s, double t) const {
    return guess.q(s, t);
  }
  /// ClosureDensity::decay_extent of a Q_n.
  virtual double decay_extent(const Polynomial& /*q*/, double /*temperature*/) const {
    return std::numeric_limits<double>::infinity();
  }
  /// Weight of each point in the fit of Q_n to a guess.
  /// @param exponent of the guess at the points
  /// @param mass of the confined guess at the points
  virtual Eigen::VectorXd fit_weights(const ClosureDensity& /*guess*/, double /*support*/,
                                      const QuadraturePoints& /*points*/,
                                      const Eigen::VectorXd& /*exponent*/,
                                      const Eigen::VectorXd& mass) const {
    return mass;
  }

  /// Decay ratio: largest density where it should have decayed, relative to the peak.
  virtual double decay_ratio(const ClosureDensity& closure, SearchStage stage) const = 0;
  /// Largest decay ratio at which no other confinement level is tried.
  virtual double decay_ratio_limit(SearchStage stage) const = 0;
};

}  // namespace fpkcheck::epc::half_plane
