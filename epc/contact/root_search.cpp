#include "epc/contact/root_search.hpp"

#include <algorithm>
#include <utility>

#include "epc/amplitude/closure_formulation.hpp"
#include "epc/contact/equations.hpp"
#include "epc/half_plane/root_search.hpp"
#include "problem/problem.hpp"
#include "problem/scales.hpp"

namespace fpkcheck::epc::contact {
namespace {

class ClosureFormulation : public amplitude::ClosureFormulation {
 public:
  ClosureFormulation(const problem::Problem& problem, const problem::MotionScales& scales,
                     const Coordinates& coordinates, TailTreatment tail)
      : amplitude::ClosureFormulation(scales.velocity_deviation * scales.velocity_deviation,
                                      relaxation_rate(problem, scales), tail),
        problem_(problem),
        coordinates_(coordinates) {}

  half_plane::QuadraturePoints points_below_energy(
      double support, const half_plane::QuadratureSize& size) const override {
    return quadrature_points(coordinates_, amplitude::amplitude_of_energy(support), size);
  }

  half_plane::ClosureEquations closure_equations(
      double support, const half_plane::Confinement& confinement, half_plane::Basis basis,
      half_plane::QuadraturePoints points, const half_plane::QuadratureSize& size) const override {
    return contact::closure_equations(problem_, coordinates_,
                                      amplitude::amplitude_of_energy(support), confinement,
                                      std::move(basis), std::move(points), size.wall);
  }

 protected:
  amplitude::PolarExponent polar_exponent(const Polynomial& q) const override {
    return contact::polar_exponent(q);
  }
  double phase(double rho, double v) const override {
    return rho > 0 ? std::asin(std::clamp(v / rho, -1.0, 1.0)) : 0;
  }

 private:
  // Relaxation rate of the energy, but at least kRounding times the frequency. In a smaller unit
  // the rounding errors of the undamped motion would dominate the residual.
  static double relaxation_rate(const problem::Problem& problem,
                                const problem::MotionScales& scales) {
    constexpr double kRounding = 1e-4;
    const double temperature = scales.velocity_deviation * scales.velocity_deviation;
    return std::max(total_intensity(problem) / (2 * temperature), kRounding * scales.frequency);
  }

  const problem::Problem& problem_;
  const Coordinates& coordinates_;
};

}  // namespace

half_plane::RootSearchResult find_root(const problem::Problem& problem,
                                       const Coordinates& coordinates, const Options& options) {
  return half_plane::find_root(
      ClosureFormulation(problem, problem::scales(problem), coordinates, options.tail), options);
}

}  // namespace fpkcheck::epc::contact
