#include <cassert>
#include <cfenv>
#include <cmath>

#include "backward/bounds/bounded_expectation.hpp"
#include "backward/bounds/residual_bounds.hpp"

namespace fpkcheck::backward {
namespace {

constexpr int kMaxBisections = 40;

// Rectangle of the phase plane with Bernstein coefficients of the residual f + L V - U of a
// certificate V.
struct ResidualPolynomialOnBox {
  numerics::Interval y_from, y_to, v_from, v_to;
  int depth;                                     // number of bisections that produced the sub-box
  std::vector<numerics::Interval> coefficients;  // shape (degree in y + 1, degree in v + 1)
};

// The three velocity factors of the generator (GeneratorVelocityFactorEnclosures), multiplied by
// the spline coefficients c_ab and summed over the splines b of v, on every piece of v and for each
// spline a of y:
// - factors[0], of A: sum_b c_ab (factor impulse_and_damping of b),
// - factors[1], of S': sum_b (c_ab - c_{a-1,b}) (factor transport of b),
// - factors[2], of (k y + mu y^3) A: sum_l (c_{a,b(l)} - c_{a,b(l-1)}) (factor restoring_force of
//   l), where b(l) is the index of function l of the piece.
struct GeneratorVelocityFactorSums {
  std::array<std::vector<numerics::Interval>, 3> factors;  // shape (pieces, functions of y, order)
};

GeneratorVelocityFactorSums contract_velocity_factors(const ResidualBoundInputs& inputs,
                                                      const Eigen::MatrixXd& c) {
  const int rows = static_cast<int>(c.rows()), order = inputs.velocity_factors.coefficient_count();
  GeneratorVelocityFactorSums result;
  for (auto& f : result.factors) {
    f.assign(inputs.velocity_factors.pieces.size() * static_cast<std::size_t>(rows * order),
             numerics::Interval(0));
  }
  for (std::size_t i = 0; i < inputs.velocity_factors.pieces.size(); ++i) {
    const auto at = [&](int term, int a) { return &result.factors[term][(i * rows + a) * order]; };
    for (int b = 0; b < c.cols(); ++b) {
      const std::span<const numerics::Interval> table =
          inputs.velocity_factors.impulse_and_damping.post_impulse_mean_coefficients(
              static_cast<int>(i), b);
      bool zero = true;
      for (const numerics::Interval& t : table) zero = zero && t.lower() == 0 && t.upper() == 0;
      if (zero) continue;
      for (int a = 0; a < rows; ++a) {
        numerics::Interval* const out = at(0, a);
        for (int j = 0; j < order; ++j) out[j] += c(a, b) * table[j];
      }
    }
    for (std::size_t l = 0; l < inputs.velocity_factors.function_indices[i].size(); ++l) {
      const int b = inputs.velocity_factors.function_indices[i][l];
      for (int a = 1; a < rows; ++a) {
        const numerics::Interval difference = numerics::Interval(c(a, b)) - c(a - 1, b);
        numerics::Interval* const drift = at(1, a);
        for (int j = 0; j < order; ++j)
          drift[j] += difference * inputs.velocity_factors.transport[i][l][j];
      }
      for (int a = 0; a < rows && l > 0; ++a) {
        const numerics::Interval difference =
            numerics::Interval(c(a, b)) - c(a, inputs.velocity_factors.function_indices[i][l - 1]);
        numerics::Interval* const force = at(2, a);
        for (int j = 0; j < order; ++j)
          force[j] += difference * inputs.velocity_factors.restoring_force[i][l - 1][j];
      }
    }
  }
  return result;
}

// Bisection of rectangles until the bounds of the weighted residual are narrow.
class BackwardResidualRangeBisection {
 public:
  BackwardResidualRangeBisection(const ResidualBoundInputs& inputs,
                                 std::pair<double, double> expected_range, double tolerance,
                                 int rows, int columns)
      : inputs_(inputs),
        rows_(rows),
        columns_(columns),
        tolerance_(tolerance),
        attained_range_(expected_range),
        reduced_stiffness_(numerics::Interval(inputs.residual_weight.stiffness) -
                           square(numerics::Interval(inputs.residual_weight.damping)) / 4.0) {}

  const BackwardResidualRange& range() const { return range_; }

  // Bounds the weighted residual on a rectangle, by bisection if its Bernstein coefficients differ
  // widely.
  void bound_residual_on_box(ResidualPolynomialOnBox box) {
    ++range_.box_count;
    // The interval from the smallest to the largest Bernstein coefficient encloses the residual on
    // a rectangle. The Bernstein coefficients at the corners are values of the residual at the
    // corners of the rectangle.
    double least = box.coefficients[0].lower(), largest = box.coefficients[0].upper();
    double rounding_error = 0;  // bound of the rounding errors, which bisection does not reduce
    bool is_finite = true;
    for (const numerics::Interval& r : box.coefficients) {
      rounding_error = std::max(rounding_error, width(r));
      least = std::min(least, r.lower());
      largest = std::max(largest, r.upper());
      is_finite = is_finite && std::isfinite(r.lower()) && std::isfinite(r.upper());
    }
    if (!is_finite) {
      range_.least = -HUGE_VAL;
      range_.largest = HUGE_VAL;
      range_.is_converged = false;
      return;
    }
    const numerics::Interval least_weight = weight_lower_bound(box);
    const double below = least < 0 ? (numerics::Interval(least) / least_weight).lower() : 0;
    const double above = largest > 0 ? (numerics::Interval(largest) / least_weight).upper() : 0;
    if (below >= range_.least && above <= range_.largest) return;
    extend_attained_range(box);
    const double tolerated = 1.5 * rounding_error / least_weight.lower() + kNegligibleResidual;
    const bool is_tight = below >= (1 + tolerance_) * attained_range_.first - tolerated &&
                          above <= (1 + tolerance_) * attained_range_.second + tolerated;
    if (is_tight || box.depth >= kMaxBisections) {
      range_.is_converged = range_.is_converged && is_tight;
      range_.least = std::min(range_.least, below);
      range_.largest = std::max(range_.largest, above);
      return;
    }
    bisect_box(box);
  }

 private:
  static constexpr double kNegligibleResidual = 1e-13;

  // Returns a lower bound of the weight tau on a rectangle, at a lower bound of the energy G.
  numerics::Interval weight_lower_bound(const ResidualPolynomialOnBox& box) const {
    const numerics::Interval y = hull(box.y_from, box.y_to), v = hull(box.v_from, box.v_to);
    const numerics::Interval w = v + numerics::Interval(inputs_.residual_weight.damping) * y / 2.0;
    const numerics::Interval y_low = std::max({0.0, box.y_from.lower(), -box.y_to.upper()});
    const numerics::Interval energy =
        square(w) / 2.0 + reduced_stiffness_ * square(y_low) / 2.0 +
        numerics::Interval(inputs_.residual_weight.cubic_stiffness) * power(y_low, 4) / 4.0;
    const numerics::Interval low = std::max(0.0, energy.lower());
    return numerics::Interval(
        (1.0 + power(low / inputs_.residual_weight.energy_scale, inputs_.residual_weight.exponent))
            .lower());
  }

  // Extends the attained range by the weighted residual at the corners of a rectangle.
  void extend_attained_range(const ResidualPolynomialOnBox& box) {
    for (const int i : {0, rows_ - 1}) {
      for (const int j : {0, columns_ - 1}) {
        const double r = box.coefficients[i * columns_ + j].lower();
        const double y = (i == 0 ? box.y_from : box.y_to).lower();
        const double v = (j == 0 ? box.v_from : box.v_to).lower();
        const double weighted_residual = r / inputs_.residual_weight(y, v);
        attained_range_.first = std::min(attained_range_.first, weighted_residual);
        attained_range_.second = std::max(attained_range_.second, weighted_residual);
      }
    }
  }

  // Bisects the rectangle in the direction, y or v, in which the Bernstein coefficients of the
  // residual vary most. Every fourth bisection of a rectangle is in the direction of least
  // variation of the residual, since the weight tau also varies. Bounds the residual on both
  // halves.
  void bisect_box(const ResidualPolynomialOnBox& box) {
    double along_y = 0, along_v = 0;
    for (int i = 0; i < rows_; ++i) {
      for (int j = 0; j < columns_; ++j) {
        const double r = box.coefficients[i * columns_ + j].upper();
        if (i > 0) {
          along_y =
              std::max(along_y, std::abs(r - box.coefficients[(i - 1) * columns_ + j].upper()));
        }
        if (j > 0)
          along_v = std::max(along_v, std::abs(r - box.coefficients[i * columns_ + j - 1].upper()));
      }
    }
    const bool bisects_y = (along_y * rows_ > along_v * columns_) != (box.depth % 4 == 3);
    ResidualPolynomialOnBox first = box, second = box;
    ++first.depth;
    ++second.depth;
    // De Casteljau's algorithm at 1/2 gives the Bernstein coefficients on both halves of a
    // rectangle. The factor 0.5 of the algorithm causes no rounding errors except for underflow.
    const int lines = bisects_y ? columns_ : rows_, n = bisects_y ? rows_ : columns_;
    const int line_step = bisects_y ? 1 : columns_, step = bisects_y ? columns_ : 1;
    for (int line = 0; line < lines; ++line) {
      numerics::Interval* const a = &first.coefficients[line * line_step];
      numerics::Interval* const b = &second.coefficients[line * line_step];
      for (int level = 1; level < n; ++level) {
        a[(level - 1) * step] = b[0];
        for (int i = 0; i + level < n; ++i) b[i * step] = 0.5 * (b[i * step] + b[(i + 1) * step]);
      }
      a[(n - 1) * step] = b[0];
    }
    if (bisects_y) {
      first.y_to = second.y_from = (box.y_from + box.y_to) / 2.0;
    } else {
      first.v_to = second.v_from = (box.v_from + box.v_to) / 2.0;
    }
    bound_residual_on_box(std::move(first));
    bound_residual_on_box(std::move(second));
  }

  const ResidualBoundInputs& inputs_;
  int rows_, columns_;
  double tolerance_;
  // Smallest and largest attained value of the weighted residual, at first the expected range
  std::pair<double, double> attained_range_;
  numerics::Interval reduced_stiffness_;  // k - c^2/4
  BackwardResidualRange range_;
};

}  // namespace

BackwardResidualRange enclose_residual_range(const ResidualBoundInputs& inputs,
                                             const StationaryFunctional& functional,
                                             const BoundCertificate& certificate,
                                             std::pair<double, double> expected_range,
                                             double tolerance) {
  assert(std::fegetround() == FE_UPWARD);
  const Eigen::MatrixXd& c = certificate.spline_coefficients;
  // The bounds require the impact condition (1) of docs/bounds.md, which the fit may violate.
  const auto satisfies_impact_condition = [&](Eigen::Index row) {
    for (int b = 0; b < inputs.velocity_basis.size(); ++b) {
      if (c(row, b) != c(row, inputs.velocity_basis.basis_index_after_impact(b))) return false;
    }
    return true;
  };
  if (inputs.displacement_ends.has_left_wall && !satisfies_impact_condition(0))
    return {-HUGE_VAL, HUGE_VAL};
  if (inputs.displacement_ends.has_right_wall && !satisfies_impact_condition(c.rows() - 1))
    return {-HUGE_VAL, HUGE_VAL};
  const int rows = inputs.displacement_basis.degree() + 4,
            columns = inputs.velocity_factors.coefficient_count();
  const int y_functions = static_cast<int>(c.rows());
  const GeneratorVelocityFactorSums v = contract_velocity_factors(inputs, c);
  const numerics::Interval jump_error = numerics::symmetric_interval(
      (numerics::Interval(inputs.velocity_factors.impulse_and_damping.remainder_bound) *
       c.cwiseAbs().maxCoeff())
          .upper());
  const bool depends_on_y = integrand_variable(functional) == StateVariable::y;
  std::vector<numerics::BernsteinCoefficients> v_integrands;
  if (!depends_on_y) {
    for (const VelocityAxisPiece& piece : inputs.velocity_factors.pieces) {
      v_integrands.push_back(
          enclose_integrand(functional, inputs.problem, piece.begin, piece.end, columns - 1));
    }
  }
  BackwardResidualRangeBisection search(inputs, expected_range, tolerance, rows, columns);
  for (std::size_t i = 0; i < inputs.displacement_factors.pieces.size(); ++i) {
    const auto& [span, y_from, y_to] = inputs.displacement_factors.pieces[i];
    const numerics::BernsteinCoefficients y_integrand =
        depends_on_y ? enclose_integrand(functional, inputs.problem, numerics::Interval(y_from),
                                         numerics::Interval(y_to), rows - 1)
                     : numerics::BernsteinCoefficients{};
    for (std::size_t j = 0; j < inputs.velocity_factors.pieces.size(); ++j) {
      ResidualPolynomialOnBox box{y_from,
                                  y_to,
                                  inputs.velocity_factors.pieces[j].begin,
                                  inputs.velocity_factors.pieces[j].end,
                                  0,
                                  {}};
      box.coefficients.assign(static_cast<std::size_t>(rows * columns),
                              jump_error - numerics::Interval(certificate.approximate_mean));
      for (int row = 0; row < rows; ++row) {
        numerics::Interval* const out = &box.coefficients[static_cast<std::size_t>(row * columns)];
        for (int q = 0; q < columns; ++q)
          out[q] += depends_on_y ? y_integrand[row] : v_integrands[j][q];
        for (int term = 0; term < 3; ++term) {
          const std::size_t first = static_cast<std::size_t>(span) + (term == 1 ? 1 : 0);
          for (std::size_t l = 0; l < inputs.displacement_factors.factors[i][term].size(); ++l) {
            const numerics::Interval factor = inputs.displacement_factors.factors[i][term][l][row];
            const numerics::Interval* const in =
                &v.factors[term][(j * y_functions + first + l) * columns];
            for (int q = 0; q < columns; ++q) out[q] += factor * in[q];
          }
        }
      }
      search.bound_residual_on_box(std::move(box));
    }
  }
  return search.range();
}

}  // namespace fpkcheck::backward
