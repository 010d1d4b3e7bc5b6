#pragma once

#include <vector>

#include "epc/half_plane/setting.hpp"
#include "epc/moment/averaged_exponent.hpp"
#include "epc/options.hpp"

namespace fpkcheck::epc::moment {

/// Formulation beyond the paper's class: wells, rings, walls at any position or none. The start is
/// the density of energy averaging instead of equivalent linearisation. The first order
/// starts from it, and every order whose start from the lower order leads to no root.
class AveragedSetting : public half_plane::Setting {
 public:
  /// @param rate_moment lambda E[Y^j], see equations()
  AveragedSetting(const problem::Problem& problem, const Options& options,
                  std::vector<double> rate_moment);

  half_plane::Shape start() const override;
  int first_order(int order) const override;
  bool any_order_can_start() const override { return true; }
  double rate_unit() const override { return rate_unit_; }
  std::vector<double> levels(const half_plane::Shape& guess,
                             half_plane::Stage stage) const override;
  std::optional<double> further(const half_plane::Shape& guess,
                                const half_plane::Shape& found) const override;
  half_plane::QuadratureSize size(int order, double level_in_temperatures,
                                  half_plane::Stage stage) const override;
  half_plane::Refinement refinement() const override;
  half_plane::Points points(double support, const half_plane::QuadratureSize& size) const override;
  half_plane::Equations equations(double support, const half_plane::Confinement& confinement,
                                  half_plane::Basis basis, half_plane::Points points,
                                  const half_plane::QuadratureSize& size) const override;
  double exponent(const half_plane::Shape& guess, double y, double v) const override;
  Eigen::VectorXd fit_weights(const half_plane::Shape& guess, double support,
                              const half_plane::Points& points, const Eigen::VectorXd& exponent,
                              const Eigen::VectorXd& mass) const override;
  double remains(const half_plane::Shape& found, half_plane::Stage stage) const override;
  double remains_allowed(half_plane::Stage stage) const override;

 private:
  std::optional<double> whole_level(const half_plane::Shape& shape, double from) const;

  const problem::Problem& problem_;
  Tail tail_;
  std::vector<double> rate_moment_;
  AveragedExponent averaged_;
  double rate_unit_;
};

}  // namespace fpkcheck::epc::moment
