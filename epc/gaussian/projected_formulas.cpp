#include "epc/gaussian/projected_formulas.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <numbers>

#include "numerics/quadrature/gauss_rule.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::epc::gaussian {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using numerics::QuadratureRule;

constexpr unsigned kPointsPerPanel = 10;
// Width of the quadrature panels in standard deviations of the Gaussian weight: width before
// refinement, and smallest width after refinement.
constexpr double kFirstPanel = 2, kLeastPanel = 0.125;
// Relative change of the weighted moments at which the refinement of the quadrature panels ends.
constexpr double kTargetError = 1e-10;
// Number of halvings of the quadrature panels next to x2 = 0, where smoothed dry friction such as
// tanh(v/eps) is steep.
constexpr int kHalvingsAtRest = 6;

// Norms of the powers of x1 and of x2 under the Gaussian weight, as in GaussianWeightedBasis.
struct WeightedMonomialNorms {
  VectorXd x1, x2;
};

VectorXd monomial_norms(int degree, double sigma) {
  VectorXd norms(degree + 1);
  double square = 1;  // E[x^2p] = sigma^2p (2p-1)!!
  for (int p = 0; p <= degree; ++p) {
    norms[p] = std::sqrt(square);
    square *= sigma * sigma * (2 * p + 1);
  }
  return norms;
}

// Radius u, in standard deviations, beyond which u^degree exp(-u^2/2) is below 1e-16 of its
// maximum. The maximum of u^degree exp(-u^2/2) is at u = sqrt(degree), and the logarithm of this
// function has a curvature of at least 1.
double integration_radius(int degree) { return std::sqrt(degree) + std::sqrt(2 * std::log(1e16)); }

// Returns the ends of quadrature panels in [low, high] that contain the breaks of the integrand, at
// distances of at most `width`.
std::vector<double> panel_ends(double low, const std::vector<double>& breaks, double high,
                               double width) {
  std::vector<double> coarse{low};
  std::ranges::copy_if(breaks, std::back_inserter(coarse),
                       [&](double x) { return low < x && x < high; });
  coarse.push_back(high);
  std::ranges::sort(coarse);
  std::vector<double> ends{low};
  for (std::size_t n = 0; n + 1 < coarse.size(); ++n) {
    const double length = coarse[n + 1] - coarse[n];
    const int panels = std::max(1, static_cast<int>(std::ceil(length / width)));
    for (int k = 1; k <= panels; ++k) ends.push_back(coarse[n] + length * k / panels);
  }
  return ends;
}

// Returns quadrature points in x, and the weights times powers of x and the normal density, divided
// by the norms of the powers: column p belongs to the power x^p.
struct GaussianWeightedPowers {
  std::vector<double> points;
  MatrixXd powers;
};

GaussianWeightedPowers weighted_powers(const std::vector<double>& ends, const VectorXd& norms,
                                       double sigma) {
  QuadratureRule rule = numerics::composite_gauss_rule<kPointsPerPanel>(ends);
  GaussianWeightedPowers result{std::move(rule.points), MatrixXd(rule.size(), norms.size())};
  const double peak = 1 / (std::sqrt(2 * std::numbers::pi) * sigma);
  for (Index i = 0; i < rule.size(); ++i) {
    const double x = result.points[i];
    double power = rule.weights[i] * peak * std::exp(-x * x / (2 * sigma * sigma));
    for (Index p = 0; p < norms.size(); ++p) {
      result.powers(i, p) = power / norms[p];
      power *= x;
    }
  }
  return result;
}

/// Domain of the quadrature in the (x1, x2) plane, whose panels end at the kinks of the formulas.
class GaussianMomentQuadrature {
 public:
  GaussianMomentQuadrature(const problem::Problem& problem, const StandardDeviations& sigma,
                           int degree)
      : folded_(problem.system.left_wall().has_value()),
        sigma_(sigma),
        norms_{monomial_norms(degree, sigma.x1), monomial_norms(degree, sigma.x2)} {
    const double radius = integration_radius(degree);
    x1_high_ = radius * sigma.x1;
    x2_high_ = radius * sigma.x2;
    x1_breaks_ = problem::coefficient_kinks_in_y(problem, folded_ ? 0 : -x1_high_, x1_high_);
    x2_breaks_ = problem::coefficient_kinks_in_v(problem, -x2_high_, x2_high_);
    x2_breaks_.push_back(0);
    for (int k = 1; k <= kHalvingsAtRest; ++k) {
      for (const int side : {-1, 1}) x2_breaks_.push_back(side * sigma.x2 * std::pow(0.5, k));
    }
  }

  const WeightedMonomialNorms& norms() const { return norms_; }

  /// Returns the moments of a function over the (x1, x2) plane under the Gaussian weight, divided
  /// by the norms of the monomials. On the (z, z') plane the function is given at x1 > 0 and is
  /// even or odd under (x1, x2) -> (-x1, -x2).
  MatrixXd plane_moments(const std::function<double(double, double)>& function, int parity,
                         double width) const {
    const auto in_x1 = weighted_powers(
        panel_ends(folded_ ? 0 : -x1_high_, x1_breaks_, x1_high_, width * sigma_.x1), norms_.x1,
        sigma_.x1);
    const auto in_x2 = weighted_powers(
        panel_ends(-x2_high_, x2_breaks_, x2_high_, width * sigma_.x2), norms_.x2, sigma_.x2);
    MatrixXd rows(std::ssize(in_x1.points), norms_.x2.size());
    VectorXd values(std::ssize(in_x2.points));
    for (Index i = 0; i < rows.rows(); ++i) {
      for (Index j = 0; j < values.size(); ++j) {
        values[j] = function(in_x1.points[i], in_x2.points[j]);
      }
      rows.row(i) = values.transpose() * in_x2.powers;
    }
    MatrixXd moments = in_x1.powers.transpose() * rows;
    if (!folded_) return moments;
    for (Index p = 0; p < moments.rows(); ++p) {
      for (Index q = 0; q < moments.cols(); ++q) {
        moments(p, q) *= ((p + q) % 2 == 0 ? 1 : -1) == parity ? 2 : 0;
      }
    }
    return moments;
  }

  /// Moments of delta(x1) times an odd function of x2, given at x2 > 0, with Gaussian weight.
  MatrixXd wall_moments(const std::function<double(double)>& odd, const std::vector<double>& kinks,
                        double width) const {
    std::vector<double> breaks = x2_breaks_;
    breaks.insert(breaks.end(), kinks.begin(), kinks.end());
    const auto in_x2 =
        weighted_powers(panel_ends(0, breaks, x2_high_, width * sigma_.x2), norms_.x2, sigma_.x2);
    VectorXd values(std::ssize(in_x2.points));
    for (Index j = 0; j < values.size(); ++j) values[j] = odd(in_x2.points[j]);
    MatrixXd moments = MatrixXd::Zero(norms_.x1.size(), norms_.x2.size());
    const double at_wall = 1 / (std::sqrt(2 * std::numbers::pi) * sigma_.x1);
    moments.row(0) = at_wall * values.transpose() * in_x2.powers;
    for (Index q = 0; q < moments.cols(); ++q) moments(0, q) *= q % 2 == 1 ? 2 : 0;
    return moments;
  }

  double x2_high() const { return x2_high_; }

 private:
  bool folded_;
  StandardDeviations sigma_;
  WeightedMonomialNorms norms_;
  double x1_high_, x2_high_;
  std::vector<double> x1_breaks_, x2_breaks_;
};

struct MomentsOnRefinedQuadrature {
  MatrixXd moments;
  double error;
};

// Halves the quadrature panels until the moments as a function of the panel width converge.
MomentsOnRefinedQuadrature refine_until_converged(
    const std::function<MatrixXd(double)>& moments_at) {
  MomentsOnRefinedQuadrature result{moments_at(kFirstPanel), 0};
  for (double width = kFirstPanel / 2; width >= kLeastPanel; width /= 2) {
    const MatrixXd finer = moments_at(width);
    const double largest = finer.cwiseAbs().maxCoeff();
    const double change = (finer - result.moments).cwiseAbs().maxCoeff();
    result.error = largest > 0 ? change / largest : change;
    result.moments = finer;
    if (result.error < kTargetError) break;
  }
  return result;
}

}  // namespace

bool has_formulas(const problem::Problem& problem) {
  return !problem.system.has_polynomial_force() || problem.noise_factor ||
         !problem.system.has_constant_restitution();
}

ProjectedFormulaTerms::ProjectedFormulaTerms(const GaussianWeightedBasis& basis,
                                             const problem::Problem& problem, double damping,
                                             double stiffness)
    : constant_(VectorXd::Zero(basis.size())), linear_(MatrixXd::Zero(basis.size(), basis.size())) {
  assert(has_formulas(problem));
  const auto& system = problem.system;
  // Degree in x1 and in x2 of the monomials in the products of basis functions
  const int n = basis.order();
  const GaussianMomentQuadrature of_force(problem, basis.weight_standard_deviations(), 2 * n);
  const auto norm_factors = [](const GaussianMomentQuadrature& of) {
    return of.norms().x1 * of.norms().x2.transpose();
  };
  const auto& wall = system.left_wall();
  const MomentsOnRefinedQuadrature force = refine_until_converged([&](double width) {
    MatrixXd moments = of_force.plane_moments(
        [&](double x1, double x2) { return system.force(x1, x2) - damping * x2 - stiffness * x1; },
        -1, width);
    if (wall && !wall->has_constant_restitution()) {
      moments += of_force.wall_moments(
          [&](double u) { return (1 - wall->restitution_at_speed(u)) * u * u; },
          wall->restitution_formula->kinks_in_v(0, of_force.x2_high()), width);
    }
    return moments;
  });
  quadrature_error_ = force.error;
  project_force_formulas(basis, force.moments.cwiseProduct(norm_factors(of_force)));
  if (!problem.noise_factor) return;
  const GaussianMomentQuadrature of_noise(problem, basis.weight_standard_deviations(), 3 * n);
  const MomentsOnRefinedQuadrature noise = refine_until_converged([&](double width) {
    return of_noise.plane_moments(
        [&](double x1, double x2) {
          return noise_diffusion_coefficient(problem, x1, x2) - problem.noise.diffusion();
        },
        1, width);
  });
  quadrature_error_ = std::max(quadrature_error_, noise.error);
  project_noise_formulas(basis, noise.moments.cwiseProduct(norm_factors(of_noise)));
}

void ProjectedFormulaTerms::project_force_formulas(const GaussianWeightedBasis& basis,
                                                   const MatrixXd& m) {
  const double precision =
      1 / (basis.weight_standard_deviations().x2 * basis.weight_standard_deviations().x2);
  for (Index s = 0; s < basis.size(); ++s) {
    const auto& [p, q, norm] = basis.basis_functions()[s];
    constant_[s] += precision * m(p, q + 1) / norm;
    if (q > 0) constant_[s] -= q * m(p, q - 1) / norm;
    for (Index k = 0; k < basis.size(); ++k) {
      const auto& of_q = basis.basis_functions()[k];
      if (of_q.q == 0) continue;
      linear_(s, k) += of_q.q * m(p + of_q.p, q + of_q.q - 1) / (norm * of_q.norm);
    }
  }
}

void ProjectedFormulaTerms::project_noise_formulas(const GaussianWeightedBasis& basis,
                                                   const MatrixXd& m) {
  const double precision =
      1 / (basis.weight_standard_deviations().x2 * basis.weight_standard_deviations().x2);
  quadratic_.assign(basis.size(), MatrixXd::Zero(basis.size(), basis.size()));
  for (Index s = 0; s < basis.size(); ++s) {
    const auto& [p, q, norm] = basis.basis_functions()[s];
    constant_[s] +=
        (precision * precision * m(p, q + 2) - (2 * q + 1) * precision * m(p, q)) / norm;
    if (q > 1) constant_[s] += q * (q - 1) * m(p, q - 2) / norm;
    for (Index k = 0; k < basis.size(); ++k) {
      const auto& [p_k, q_k, norm_k] = basis.basis_functions()[k];
      if (q_k == 0) continue;
      const double of_slopes = 2 * q_k * precision * m(p + p_k, q + q_k);
      const double derivatives = q_k * (2 * q + q_k - 1);
      linear_(s, k) += of_slopes / (norm * norm_k);
      if (derivatives != 0) {
        linear_(s, k) -= derivatives * m(p + p_k, q + q_k - 2) / (norm * norm_k);
      }
      for (Index l = 0; l < basis.size(); ++l) {
        const auto& [p_l, q_l, norm_l] = basis.basis_functions()[l];
        if (q_l == 0) continue;
        quadratic_[s](k, l) =
            q_k * q_l * m(p + p_k + p_l, q + q_k + q_l - 2) / (norm * norm_k * norm_l);
      }
    }
  }
}

VectorXd ProjectedFormulaTerms::projected_formula_terms(const VectorXd& a) const {
  VectorXd result = constant_ + linear_ * a;
  for (std::size_t s = 0; s < quadratic_.size(); ++s) {
    result[static_cast<Index>(s)] += a.dot(quadratic_[s] * a);
  }
  return result;
}

MatrixXd ProjectedFormulaTerms::jacobian(const VectorXd& a) const {
  MatrixXd result = linear_;
  for (std::size_t s = 0; s < quadratic_.size(); ++s) {
    // the matrix is symmetric
    result.row(static_cast<Index>(s)) += 2 * (quadratic_[s] * a).transpose();
  }
  return result;
}

}  // namespace fpkcheck::epc::gaussian
