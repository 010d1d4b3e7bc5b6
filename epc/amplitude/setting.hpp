#pragma once

#include "epc/amplitude/circle.hpp"
#include "epc/half_plane/setting.hpp"
#include "epc/options.hpp"

namespace fpkcheck::epc::amplitude {

/// The exponent of a density on the way: Q_n as far as it falls, and from there on a Gaussian.
/// @param q Q_n by amplitude and phase
double exponent_on_the_way(const Exponent& q, const half_plane::Shape& shape, double rho,
                           double theta);

/// By how much more points may change Q_n, in standard deviations: below what the exponent's shape
/// leaves at the usual orders.
inline constexpr double kQuadratureAllowed = 1e-3;

/// What the search must know where s is the amplitude. The level lies where Q_n is far below its
/// peak, else beyond the amplitude at which it rises again; energies are rho^2/2.
class Setting : public half_plane::Setting {
 public:
  /// @param temperature E[v^2] of the Gaussian from which the first order starts, about
  /// @param rate_unit the measure of rates of change
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
  /// Q_n by amplitude and phase, as long as q lives.
  virtual Exponent on_circle(const Polynomial& q) const = 0;
  /// The phase of s and t.
  virtual double phase(double s, double t) const = 0;

 private:
  double temperature_, rate_unit_;
  Tail tail_;
};

/// Why a density is held by its confinement alone; empty when it is not.
/// @param what of the density is looked at, as the reason calls it
/// @param at_level the largest of it where the confinement begins or beyond, relative to the peak
/// @param edge     the same on the edge of the support
std::string objection(const char* what, double at_level, double edge);

}  // namespace fpkcheck::epc::amplitude
