#pragma once

#include <optional>
#include <vector>

#include "epc/half_plane/confinement.hpp"
#include "epc/half_plane/equations.hpp"
#include "epc/half_plane/root.hpp"

namespace fpkcheck::epc::half_plane {

/// How well an order is to be solved.
enum class Stage {
  rough,  ///< on the way, to start the next order from
  last    ///< the order asked for
};

/// When the points of the quadrature are enough.
struct Refinement {
  enum class Rule {
    /// More points are solved on too, and the root there is taken.
    solved,
    /// The change is that of one Newton step on more points, and the root before is kept.
    estimated
  };
  Rule rule;
  double tolerance;  ///< on the standard deviation of the change of Q_n
};

/// What the search over levels must know of a formulation: its coordinates, its equations, and
/// where a density with the exponent Q_n may be confined. An energy is that of Points.
class Setting {
 public:
  virtual ~Setting() = default;

  /// The density from which the first order starts.
  virtual Shape start() const = 0;
  /// The first order that is solved on the way to one.
  virtual int first_order(int /*order*/) const { return 2; }
  /// Whether any order may start from it, where the one before leads to no root.
  virtual bool any_order_can_start() const { return false; }
  /// The measure of rates of change.
  virtual double rate_unit() const = 0;
  /// The energies at which the confinement may begin, in the order in which they are to be tried.
  virtual std::vector<double> levels(const Shape& guess, Stage stage) const = 0;
  /// A level further out that the root found at one shows to be better.
  virtual std::optional<double> further(const Shape& /*guess*/, const Shape& /*found*/) const {
    return std::nullopt;
  }

  /// Points enough for a first try.
  /// @param level_in_temperatures of the guess
  virtual QuadratureSize size(int order, double level_in_temperatures, Stage stage) const = 0;
  virtual Refinement refinement() const = 0;
  /// The rule on the part of the half-plane below an energy.
  virtual Points points(double support, const QuadratureSize& size) const = 0;
  /// The equations on those points.
  virtual Equations equations(double support, const Confinement& confinement, Basis basis,
                              Points points, const QuadratureSize& size) const = 0;

  /// The exponent of a guess; where Q_n rises again it may go on otherwise.
  virtual double exponent(const Shape& guess, double s, double t) const { return guess.q(s, t); }
  /// Shape::trusted of a Q_n.
  virtual double trusted(const Polynomial& /*q*/, double /*temperature*/) const {
    return std::numeric_limits<double>::infinity();
  }
  /// How much each point counts when Q_n is fitted to a guess.
  /// @param exponent of the guess at the points
  /// @param mass of the confined guess there
  virtual Eigen::VectorXd fit_weights(const Shape& /*guess*/, double /*support*/,
                                      const Points& /*points*/, const Eigen::VectorXd& /*exponent*/,
                                      const Eigen::VectorXd& mass) const {
    return mass;
  }

  /// Largest density, relative to the peak, at a place where it should have decayed.
  virtual double remains(const Shape& found, Stage stage) const = 0;
  /// What may remain without another level being tried.
  virtual double remains_allowed(Stage stage) const = 0;
};

}  // namespace fpkcheck::epc::half_plane
