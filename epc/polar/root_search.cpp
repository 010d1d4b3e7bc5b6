#include "epc/polar/root_search.hpp"

#include <utility>

#include "epc/amplitude/closure_formulation.hpp"
#include "epc/half_plane/norms.hpp"
#include "epc/half_plane/root_search.hpp"
#include "epc/polar/equations.hpp"
#include "problem/equivalent_linearisation.hpp"

namespace fpkcheck::epc::polar {
namespace {

// Temperature of the initial density: the mean square velocity of equivalent linearisation, plus
// the potential energy of the static deflection.
double temperature_of(const problem::Problem& problem, const Coordinates& coordinates) {
  const double sigma = problem::equivalent_linearisation(problem).velocity_deviation;
  const double centre = coordinates.potential_speed(problem::static_deflection(problem));
  return sigma * sigma + centre * centre / 2;
}

class ClosureFormulation : public amplitude::ClosureFormulation {
 public:
  ClosureFormulation(const problem::Problem& problem, const Coordinates& coordinates,
                     TailTreatment tail)
      : amplitude::ClosureFormulation(temperature_of(problem, coordinates),
                                      half_plane::rate_of_change_unit(problem), tail),
        problem_(problem),
        coordinates_(coordinates) {}

  half_plane::QuadraturePoints points_below_energy(
      double support, const half_plane::QuadratureSize& size) const override {
    const double rho_max = amplitude::amplitude_of_energy(support);
    return quadrature_points(coordinates_, rho_max,
                             amplitude_break_points(problem_.impulses.law(), rho_max), size);
  }

  half_plane::ClosureEquations closure_equations(
      double support, const half_plane::Confinement& confinement, half_plane::Basis basis,
      half_plane::QuadraturePoints points, const half_plane::QuadratureSize& size) const override {
    return polar::closure_equations(problem_, coordinates_, amplitude::amplitude_of_energy(support),
                                    confinement, std::move(basis), std::move(points), size.wall);
  }

 protected:
  amplitude::PolarExponent polar_exponent(const Polynomial& q) const override {
    return polar::polar_exponent(q);
  }
  double phase(double, double theta) const override { return theta; }

 private:
  const problem::Problem& problem_;
  const Coordinates& coordinates_;
};

}  // namespace

half_plane::RootSearchResult find_root(const problem::Problem& problem,
                                       const Coordinates& coordinates, const Options& options) {
  return half_plane::find_root(ClosureFormulation(problem, coordinates, options.tail), options);
}

}  // namespace fpkcheck::epc::polar
