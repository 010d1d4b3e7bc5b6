#include "epc/amplitude/impulse_means.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <tuple>

namespace fpkcheck::epc::amplitude {
namespace {

constexpr double kPanel = 1.2;       // width of the widest panel, in standard deviations of Y
constexpr double kFirstBreak = 1.5;  // break point nearest to velocity 0, in units of `width`
constexpr double kGrowth = 3;
constexpr double kNegligible = 1e-18;  // probability below which a point is omitted

}  // namespace

GradedImpulseQuadrature::GradedImpulseQuadrature(const problem::ImpulseLaw& law)
    : law_(law), pieces_(law.amplitude_density_breakpoints()), atoms_(law.amplitude_atoms()) {}

const VelocitiesAfterImpulse& GradedImpulseQuadrature::operator()(double v, double width) {
  after_.v.clear();
  after_.probability.clear();
  for (const auto& [amplitude, probability] : atoms_) {
    after_.v.push_back(v + amplitude);
    after_.probability.push_back(probability);
  }
  if (pieces_.empty()) return after_;

  breaks_.clear();
  for (const double piece : pieces_) breaks_.push_back(v + piece);
  const double low = breaks_.front(), high = breaks_.back();
  const auto add_break = [&](double at) {
    if (at > low && at < high) breaks_.push_back(at);
  };
  add_break(0);
  for (double at = kFirstBreak * width; at > 0 && at < law_.amplitude_standard_deviation();
       at *= kGrowth) {
    add_break(at);
    add_break(-at);
  }
  std::ranges::sort(breaks_);
  for (std::size_t i = 0; i + 1 < breaks_.size(); ++i) {
    const double step = breaks_[i + 1] - breaks_[i];
    const int panels =
        static_cast<int>(std::ceil(step / (kPanel * law_.amplitude_standard_deviation())));
    for (int k = 0; k < panels; ++k) {
      add_quadrature_panel(breaks_[i] + step * k / panels, breaks_[i] + step * (k + 1) / panels, v);
    }
  }
  return after_;
}

void GradedImpulseQuadrature::add_quadrature_panel(double from, double to, double v) {
  using Rule = boost::math::quadrature::gauss<double, 8>;
  const double half = (to - from) / 2, centre = (from + to) / 2;
  for (std::size_t i = 0; i < Rule::abscissa().size(); ++i) {
    for (const double side : {-1, 1}) {
      const double at = centre + side * half * Rule::abscissa()[i];
      const double probability = half * Rule::weights()[i] * law_.density(at - v);
      if (probability < kNegligible) continue;
      after_.v.push_back(at);
      after_.probability.push_back(probability);
    }
  }
}

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd means_after_impulse(const problem::ImpulseLaw& law,
                             const half_plane::OrthonormalBasis& basis, const VectorXd& w,
                             const VectorXd& v, const CoordinatesOfPhasePoint& coordinates) {
  GradedImpulseQuadrature rule(law);
  MatrixXd result(v.size(), basis.size());
  for (Index i = 0; i < v.size(); ++i) {
    const VelocitiesAfterImpulse& after = rule(v[i], w[i]);
    const auto count = static_cast<Index>(after.v.size());
    VectorXd s(count), t(count);
    for (Index k = 0; k < count; ++k) std::tie(s[k], t[k]) = coordinates(w[i], after.v[k]);
    const Eigen::Map<const VectorXd> probability(after.probability.data(), count);
    const MatrixXd means = basis.polynomials_in_s().polynomial_values(s).transpose() *
                           probability.asDiagonal() * basis.polynomials_in_t().polynomial_values(t);
    for (Index k = 0; k < basis.size(); ++k) {
      const auto& [p, q] = basis.basis_functions()[k];
      result(i, k) = means(p, q);
    }
  }
  return result;
}

}  // namespace fpkcheck::epc::amplitude
