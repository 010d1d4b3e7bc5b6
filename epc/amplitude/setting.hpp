#pragma once

#include "epc/amplitude/circle.hpp"
#include "epc/half_plane/setting.hpp"
#include "epc/options.hpp"

namespace fpkcheck::epc::amplitude {

/// Exponent of an intermediate density: Q_n up to the decay extent, and a Gaussian beyond.
/// @param q Q_n by amplitude and phase
double exponent_on_the_way(const Exponent& q, const half_plane::Shape& shape, double rho,
                           double theta);

/// Tolerance on the change of Q_n on more quadrature points, in standard deviations. It is below
/// the error of the closure itself at the default orders.
inline constexpr double kQuadratureAllowed = 1e-3;

/// Formulation in which s is the amplitude. The confinement level is an energy rho^2/2 at which Q_n
/// lies far below its peak, or else an energy beyond the amplitude at which Q_n rises again.
class Setting : public half_plane::Setting {
 public:
  /// @param temperature approximate E[v^2] of the Gaussian from which the first order starts
  /// @param rate_unit unit of rates of change
  Setting(double temperature, double rate_unit, Tail tail)
      : temperature_(temperature), rate_unit_(rate_unit), tail_(tail) {}

  half_plane::Shape start() const override;
  double rate_unit() const override { return rate_unit_; }
  std::vector<double> levels(const half_plane::Shape& guess,
                             half_plane::Stage stage) const override;
  half_plane::QuadratureSize size(int order, double level_in_temperatures,
                                  half_plane::Stage stage) const override;
  half_plane::Refinement refinement() const override;
  double exponent(const half_plane::Shape& guess, double s, double t) const override;
  double trusted(const Polynomial& q, double temperature) const override;
  Eigen::VectorXd fit_weights(const half_plane::Shape& guess, double support,
                              const half_plane::Points& points, const Eigen::VectorXd& exponent,
                              const Eigen::VectorXd& mass) const override;
  double remains(const half_plane::Shape& found, half_plane::Stage stage) const override;
  double remains_allowed(half_plane::Stage stage) const override;

 protected:
  /// Q_n by amplitude and phase. The result refers to q.
  virtual Exponent on_circle(const Polynomial& q) const = 0;
  /// Phase at the coordinates s and t.
  virtual double phase(double s, double t) const = 0;

 private:
  double temperature_, rate_unit_;
  Tail tail_;
};

/// Reason why a density is inadmissible: its confinement alone makes it decay. Empty otherwise.
/// @param what name of the quantity in the reason
/// @param at_level largest value at or beyond the confinement level, relative to the peak
/// @param edge     largest value on the edge of the support, relative to the peak
std::string objection(const char* what, double at_level, double edge);

}  // namespace fpkcheck::epc::amplitude
