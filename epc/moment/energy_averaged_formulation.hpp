#pragma once

#include <vector>

#include "epc/half_plane/closure_formulation.hpp"
#include "epc/moment/energy_averaged_exponent.hpp"
#include "epc/options.hpp"

namespace fpkcheck::epc::moment {

/// Formulation `moment` for oscillators other than the paper's: several wells, ring-shaped
/// densities, walls at any position, or no wall. The initial density is the density of energy
/// averaging instead of equivalent linearisation. The first order starts from this density. A
/// higher order starts from this density if the search from the next lower order finds no root.
class EnergyAveragedFormulation : public half_plane::ClosureFormulation {
 public:
  /// @param rate_times_moment products lambda E[Y^j], see closure_equations()
  EnergyAveragedFormulation(const problem::Problem& problem, const Options& options,
                            std::vector<double> rate_times_moment);

  half_plane::ClosureDensity initial_density() const override;
  int first_order(int order) const override;
  bool can_start_at_any_order() const override { return true; }
  double rate_of_change_unit() const override { return rate_unit_; }
  std::vector<double> confinement_levels(const half_plane::ClosureDensity& guess,
                                         half_plane::SearchStage stage) const override;
  std::optional<double> improved_confinement_level(
      const half_plane::ClosureDensity& guess,
      const half_plane::ClosureDensity& closure) const override;
  half_plane::QuadratureSize quadrature_size(int order, double level_over_temperature,
                                             half_plane::SearchStage stage) const override;
  half_plane::QuadratureRefinement quadrature_refinement() const override;
  half_plane::QuadraturePoints points_below_energy(
      double support, const half_plane::QuadratureSize& size) const override;
  half_plane::ClosureEquations closure_equations(
      double support, const half_plane::Confinement& confinement, half_plane::Basis basis,
      half_plane::QuadraturePoints points, const half_plane::QuadratureSize& size) const override;
  double exponent_of_guess(const half_plane::ClosureDensity& guess, double y,
                           double v) const override;
  Eigen::VectorXd fit_weights(const half_plane::ClosureDensity& guess, double support,
                              const half_plane::QuadraturePoints& points,
                              const Eigen::VectorXd& exponent,
                              const Eigen::VectorXd& mass) const override;
  double decay_ratio(const half_plane::ClosureDensity& closure,
                     half_plane::SearchStage stage) const override;
  double decay_ratio_limit(half_plane::SearchStage stage) const override;

 private:
  std::optional<double> negligible_level(const half_plane::ClosureDensity& closure,
                                         double from) const;

  const problem::Problem& problem_;
  TailTreatment tail_;
  std::vector<double> rate_moment_;
  EnergyAveragedExponent averaged_;
  double rate_unit_;
};

}  // namespace fpkcheck::epc::moment
