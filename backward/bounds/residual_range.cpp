#include <cassert>
#include <cfenv>
#include <cmath>

#include "backward/bounds/functional.hpp"
#include "backward/bounds/residual_bounds.hpp"

namespace fpkcheck::backward {
namespace {

constexpr int kMaxBisections = 40;

// Sub-box of the product of two pieces, with the Bernstein coefficients of the residual.
struct Box {
  numerics::Interval y_from, y_to, v_from, v_to;
  int depth;
  std::vector<numerics::Interval> residual;  // shape (degree in y + 1, degree in v + 1)
};

// Products of the three velocity factors of the generator and spline coefficients, summed over the
// splines of v, on every piece of v and for each spline a of y. The factor of A is multiplied by
// the coefficients c_a, and the factor of S' by the differences c_a - c_{a-1}. The factor of the
// force is multiplied by differences of c_a between neighbouring splines of v.
struct ContractedFactors {
  std::array<std::vector<numerics::Interval>, 3> factors;  // shape (pieces, functions of y, order)
};

ContractedFactors contract_factors(const CertificateCheckInputs& s, const Eigen::MatrixXd& c) {
  const int rows = static_cast<int>(c.rows()), order = s.v.order();
  ContractedFactors result;
  for (auto& f : result.factors) {
    f.assign(s.v.pieces.size() * static_cast<std::size_t>(rows * order), numerics::Interval(0));
  }
  for (std::size_t i = 0; i < s.v.pieces.size(); ++i) {
    const auto at = [&](int term, int a) { return &result.factors[term][(i * rows + a) * order]; };
    for (int b = 0; b < c.cols(); ++b) {
      const std::span<const numerics::Interval> table =
          s.v.jump.coefficients_of(static_cast<int>(i), b);
      bool zero = true;
      for (const numerics::Interval& t : table) zero = zero && t.lower() == 0 && t.upper() == 0;
      if (zero) continue;
      for (int a = 0; a < rows; ++a) {
        numerics::Interval* const out = at(0, a);
        for (int j = 0; j < order; ++j) out[j] += c(a, b) * table[j];
      }
    }
    for (std::size_t l = 0; l < s.v.index[i].size(); ++l) {
      const int b = s.v.index[i][l];
      for (int a = 1; a < rows; ++a) {
        const numerics::Interval difference = numerics::Interval(c(a, b)) - c(a - 1, b);
        numerics::Interval* const drift = at(1, a);
        for (int j = 0; j < order; ++j) drift[j] += difference * s.v.drift[i][l][j];
      }
      for (int a = 0; a < rows && l > 0; ++a) {
        const numerics::Interval difference =
            numerics::Interval(c(a, b)) - c(a, s.v.index[i][l - 1]);
        numerics::Interval* const force = at(2, a);
        for (int j = 0; j < order; ++j) force[j] += difference * s.v.force[i][l - 1][j];
      }
    }
  }
  return result;
}

class RangeSearch {
 public:
  RangeSearch(const CertificateCheckInputs& context, std::pair<double, double> expected_range,
              double tolerance, int rows, int columns)
      : s_(context),
        rows_(rows),
        columns_(columns),
        tolerance_(tolerance),
        attained_(expected_range),
        stiffness_(numerics::Interval(context.weight.stiffness) -
                   square(numerics::Interval(context.weight.damping)) / 4.0) {}

  const ResidualRange& range() const { return range_; }

  void process(Box box) {
    ++range_.boxes;
    // The range of the Bernstein coefficients encloses the residual on the box. The coefficients at
    // the corners are values of the residual at the corners of the box.
    double least = box.residual[0].lower(), largest = box.residual[0].upper();
    double noise = 0;  // bound of the rounding errors, which bisection does not reduce
    bool is_finite = true;
    for (const numerics::Interval& r : box.residual) {
      noise = std::max(noise, width(r));
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
    const numerics::Interval least_weight = min_weight(box);
    const double below = least < 0 ? (numerics::Interval(least) / least_weight).lower() : 0;
    const double above = largest > 0 ? (numerics::Interval(largest) / least_weight).upper() : 0;
    if (below >= range_.least && above <= range_.largest) return;
    sample_corners(box);
    const double tolerated = 1.5 * noise / least_weight.lower() + kNegligible;
    const bool is_tight = below >= (1 + tolerance_) * attained_.first - tolerated &&
                          above <= (1 + tolerance_) * attained_.second + tolerated;
    if (is_tight || box.depth >= kMaxBisections) {
      range_.is_converged = range_.is_converged && is_tight;
      range_.least = std::min(range_.least, below);
      range_.largest = std::max(range_.largest, above);
      return;
    }
    bisect(box);
  }

 private:
  static constexpr double kNegligible = 1e-13;

  // Returns a lower bound of the weight tau on the box: the value of tau at a lower bound of the
  // energy G.
  numerics::Interval min_weight(const Box& box) const {
    const numerics::Interval y = hull(box.y_from, box.y_to), v = hull(box.v_from, box.v_to);
    const numerics::Interval w = v + numerics::Interval(s_.weight.damping) * y / 2.0;
    const numerics::Interval y_low = std::max({0.0, box.y_from.lower(), -box.y_to.upper()});
    const numerics::Interval energy = square(w) / 2.0 + stiffness_ * square(y_low) / 2.0 +
                                      numerics::Interval(s_.weight.cubic) * power(y_low, 4) / 4.0;
    const numerics::Interval low = std::max(0.0, energy.lower());
    return numerics::Interval((1.0 + power(low / s_.weight.scale, s_.weight.power)).lower());
  }

  void sample_corners(const Box& box) {
    for (const int i : {0, rows_ - 1}) {
      for (const int j : {0, columns_ - 1}) {
        const double r = box.residual[i * columns_ + j].lower();
        const double y = (i == 0 ? box.y_from : box.y_to).lower();
        const double v = (j == 0 ? box.v_from : box.v_to).lower();
        const double weighted_residual = r / s_.weight(y, v);
        attained_.first = std::min(attained_.first, weighted_residual);
        attained_.second = std::max(attained_.second, weighted_residual);
      }
    }
  }

  // Bisects the box in the direction, y or v, in which the coefficients of the residual vary most.
  // Every fourth bisection is in the second direction, since the weight tau also varies.
  void bisect(const Box& box) {
    double along_y = 0, along_v = 0;
    for (int i = 0; i < rows_; ++i) {
      for (int j = 0; j < columns_; ++j) {
        const double r = box.residual[i * columns_ + j].upper();
        if (i > 0) {
          along_y = std::max(along_y, std::abs(r - box.residual[(i - 1) * columns_ + j].upper()));
        }
        if (j > 0)
          along_v = std::max(along_v, std::abs(r - box.residual[i * columns_ + j - 1].upper()));
      }
    }
    const bool in_y = (along_y * rows_ > along_v * columns_) != (box.depth % 4 == 3);
    Box first = box, second = box;
    ++first.depth;
    ++second.depth;
    // de Casteljau's algorithm at 1/2, where halving is exact except for underflow
    const int lines = in_y ? columns_ : rows_, n = in_y ? rows_ : columns_;
    const int line_step = in_y ? 1 : columns_, step = in_y ? columns_ : 1;
    for (int line = 0; line < lines; ++line) {
      numerics::Interval* const a = &first.residual[line * line_step];
      numerics::Interval* const b = &second.residual[line * line_step];
      for (int level = 1; level < n; ++level) {
        a[(level - 1) * step] = b[0];
        for (int i = 0; i + level < n; ++i) b[i * step] = 0.5 * (b[i * step] + b[(i + 1) * step]);
      }
      a[(n - 1) * step] = b[0];
    }
    if (in_y) {
      first.y_to = second.y_from = (box.y_from + box.y_to) / 2.0;
    } else {
      first.v_to = second.v_from = (box.v_from + box.v_to) / 2.0;
    }
    process(std::move(first));
    process(std::move(second));
  }

  const CertificateCheckInputs& s_;
  int rows_, columns_;
  double tolerance_;
  std::pair<double, double> attained_;
  numerics::Interval stiffness_;  // reduced stiffness k - c^2/4
  ResidualRange range_;
};

}  // namespace

ResidualRange residual_range(const CertificateCheckInputs& s, const Functional& functional,
                             const Certificate& certificate,
                             std::pair<double, double> expected_range, double tolerance) {
  assert(std::fegetround() == FE_UPWARD);
  const Eigen::MatrixXd& c = certificate.coefficients;
  // The fit does not guarantee the impact condition (1) of docs/bounds.md, therefore the impact
  // condition is checked.
  const auto satisfies_impact_condition = [&](Eigen::Index row) {
    for (int b = 0; b < s.velocity.size(); ++b) {
      if (c(row, b) != c(row, s.velocity.mirrored_index(b))) return false;
    }
    return true;
  };
  if (s.ends.left_wall && !satisfies_impact_condition(0)) return {-HUGE_VAL, HUGE_VAL};
  if (s.ends.right_wall && !satisfies_impact_condition(c.rows() - 1)) return {-HUGE_VAL, HUGE_VAL};
  const int rows = s.displacement.degree() + 4, columns = s.v.order();
  const int y_functions = static_cast<int>(c.rows());
  const ContractedFactors v = contract_factors(s, c);
  const numerics::Interval jump_error = numerics::symmetric_interval(
      (numerics::Interval(s.v.jump.remainder) * c.cwiseAbs().maxCoeff()).upper());
  const bool of_y = axis_of(functional) == Axis::displacement;
  std::vector<numerics::BernsteinCoefficients> f_of_v;
  if (!of_y) {
    for (const VelocityPiece& piece : s.v.pieces) {
      f_of_v.push_back(
          integrand_enclosure(functional, s.problem, piece.from, piece.to, columns - 1));
    }
  }
  RangeSearch search(s, expected_range, tolerance, rows, columns);
  for (std::size_t i = 0; i < s.y.pieces.size(); ++i) {
    const auto& [span, y_from, y_to] = s.y.pieces[i];
    const numerics::BernsteinCoefficients f_of_y =
        of_y ? integrand_enclosure(functional, s.problem, numerics::Interval(y_from),
                                   numerics::Interval(y_to), rows - 1)
             : numerics::BernsteinCoefficients{};
    for (std::size_t j = 0; j < s.v.pieces.size(); ++j) {
      Box box{y_from, y_to, s.v.pieces[j].from, s.v.pieces[j].to, 0, {}};
      box.residual.assign(static_cast<std::size_t>(rows * columns),
                          jump_error - numerics::Interval(certificate.mean));
      for (int row = 0; row < rows; ++row) {
        numerics::Interval* const out = &box.residual[static_cast<std::size_t>(row * columns)];
        for (int q = 0; q < columns; ++q) out[q] += of_y ? f_of_y[row] : f_of_v[j][q];
        for (int term = 0; term < 3; ++term) {
          const std::size_t first = static_cast<std::size_t>(span) + (term == 1 ? 1 : 0);
          for (std::size_t l = 0; l < s.y.factors[i][term].size(); ++l) {
            const numerics::Interval factor = s.y.factors[i][term][l][row];
            const numerics::Interval* const in =
                &v.factors[term][(j * y_functions + first + l) * columns];
            for (int q = 0; q < columns; ++q) out[q] += factor * in[q];
          }
        }
      }
      search.process(std::move(box));
    }
  }
  return search.range();
}

}  // namespace fpkcheck::backward
