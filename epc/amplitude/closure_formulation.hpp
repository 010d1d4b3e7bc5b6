#pragma once

#include <string>

#include "epc/amplitude/amplitude_equations.hpp"
#include "epc/half_plane/root_assessment.hpp"
#include "epc/half_plane/root_search.hpp"
#include "epc/options.hpp"

namespace fpkcheck::epc::amplitude {

/// Returns the exponent of the closure density at an intermediate closure order: The exponent is
/// Q_n up to the amplitude at which Q_n may rise, and that of a Gaussian density above it.
double exponent_with_gaussian_tail(const ExponentInPolarCoordinates& q,
                                   const half_plane::ClosureDensity& closure, double rho,
                                   double theta);

/// Largest accepted change of the exponent Q_n when quadrature points are added, in standard
/// deviations under the density. The tolerance 1e-3 on the exponent Q_n is below the error of
/// closures of the default order.
inline constexpr double kQuadratureTolerance = 1e-3;

/// Closure formulation in which the first coordinate s of the exponent is the amplitude rho. The
/// confinement level of the closure density is the energy at which the exponent Q_n lies far below
/// its peak, or else an energy beyond the amplitude at which Q_n begins to rise.
class ClosureFormulation : public half_plane::ClosureFormulation {
 public:
  /// @param temperature approximate value of E[v^2] for the initial Gaussian density
  ClosureFormulation(double temperature, double relaxation_rate_unit, DensityTailTreatment tail)
      : temperature_(temperature), rate_unit_(relaxation_rate_unit), tail_(tail) {}

  half_plane::ClosureDensity initial_density() const override;
  double relaxation_rate_unit() const override { return rate_unit_; }
  std::vector<double> candidate_confinement_energies(
      const half_plane::ClosureDensity& guess,
      half_plane::ClosureRootSearchStage stage) const override;
  half_plane::QuadraturePointCounts quadrature_point_counts(
      int order, double level_over_temperature,
      half_plane::ClosureRootSearchStage stage) const override;
  half_plane::QuadratureRefinementCriterion quadrature_refinement_criterion() const override;
  double exponent_of_initial_guess(const half_plane::ClosureDensity& guess, double s,
                                   double t) const override;
  double end_of_exponent_decay(const ExponentPolynomial& q, double temperature) const override;
  Eigen::VectorXd weights_of_exponent_fit(const half_plane::ClosureDensity& guess, double support,
                                          const half_plane::QuadraturePoints& points,
                                          const Eigen::VectorXd& exponent,
                                          const Eigen::VectorXd& mass) const override;
  double decay_ratio(const half_plane::ClosureDensity& closure,
                     half_plane::ClosureRootSearchStage stage) const override;
  double max_decay_ratio(half_plane::ClosureRootSearchStage stage) const override;

 protected:
  /// Returns the exponent Q_n as a function of amplitude and phase. The function of amplitude and
  /// phase keeps a reference to the polynomial q.
  virtual ExponentInPolarCoordinates polar_exponent(const ExponentPolynomial& q) const = 0;
  /// Returns the phase theta of the point with the amplitude s and the phase or velocity t.
  virtual double phase(double s, double t) const = 0;

 private:
  double temperature_, rate_unit_;
  DensityTailTreatment tail_;
};

/// Returns the reason why the closure density is inadmissible if only the confinement term causes
/// its decay. The reason is empty for an admissible density.
/// @param quantity name of the checked quantity, for the reason
/// @param at_level largest value of the quantity at the confinement level, relative to its peak
/// @param edge largest value of the quantity on the edge of the support, relative to its peak
std::string inadmissible_reason(const char* quantity, double at_level, double edge);

template <class Coordinates>
class CoordinateFormulation final : public ClosureFormulation {
 public:
  CoordinateFormulation(const problem::Problem& problem, const Coordinates& coordinates,
                        double temperature, double unit, DensityTailTreatment tail)
      : ClosureFormulation(temperature, unit, tail), problem_(problem), coordinates_(coordinates) {}

  half_plane::QuadraturePoints quadrature_points_below_energy(
      double support, const half_plane::QuadraturePointCounts& size) const override {
    const double rho_max = amplitude_of_energy(support);
    return quadrature_points(
        coordinates_, rho_max,
        Coordinates::amplitude_break_points(problem_.impulses.amplitude_law(), rho_max), size);
  }
  half_plane::ClosureEquations closure_equations(
      double support, const half_plane::ExponentConfinementTerm& confinement,
      half_plane::OrthonormalBasis basis, half_plane::QuadraturePoints points,
      const half_plane::QuadraturePointCounts& size) const override {
    return amplitude::closure_equations(problem_, coordinates_, amplitude_of_energy(support),
                                        confinement, std::move(basis), std::move(points),
                                        size.wall);
  }

 protected:
  ExponentInPolarCoordinates polar_exponent(const ExponentPolynomial& q) const override {
    return amplitude::polar_exponent<Coordinates>(q);
  }
  double phase(double s, double t) const override { return Coordinates::phase(s, t); }

 private:
  const problem::Problem& problem_;
  const Coordinates& coordinates_;
};

/// Stores leading form, closed form and support of a root in a result that already contains the
/// density, and sets the status.
/// @param quantity name of the decaying quantity, for the reason of the status
template <class Coordinates>
void assess_closure_root(const problem::Problem& problem, const Coordinates& coordinates,
                         const half_plane::ClosureRootSearchResult& root, DensityTailTreatment tail,
                         const transform::SmoothDensity& density, const char* quantity,
                         ClosureResult& result) {
  const half_plane::ClosureDensity& closure = root.closure;
  ClosureSummary& summary = result.summary;
  const StandardDeviations sigma = half_plane::root_mean_squares(summary.moments);
  summary.leading_form = leading_form_of_amplitude_exponent<Coordinates>(closure.q, sigma);
  summary.frame = half_plane::closed_form_parameters(closure, tail, Coordinates::kVariables);
  summary.frame->coordinates = problem.frame;
  const double support = amplitude_of_energy(closure.support);
  const double edge = std::exp(
      maximum_over_phase(amplitude::polar_exponent<Coordinates>(closure.q), support) +
      half_plane::make_exponent_confinement(closure.level, tail)(closure.support) - closure.peak);
  half_plane::store_half_plane_summary(
      root, tail, density, sigma,
      {.support = constant_amplitude_contour(coordinates, support),
       .level = constant_amplitude_contour(coordinates, amplitude_of_energy(closure.level)),
       .density = edge},
      result);
  half_plane::set_status(root, kQuadratureTolerance,
                         inadmissible_reason(quantity, root.decay_ratio, edge), result);
}

}  // namespace fpkcheck::epc::amplitude
