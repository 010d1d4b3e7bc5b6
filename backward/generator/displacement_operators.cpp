#include "backward/generator/displacement_operators.hpp"

#include "backward/generator/partial_sum_slopes.hpp"
#include "numerics/splines/bezier_extraction.hpp"

namespace fpkcheck::backward {

DisplacementOperators displacement_operators(const problem::Problem& problem,
                                             const numerics::SplineBasis& basis,
                                             std::span<const double> cuts) {
  const problem::SystemCoefficients& c = problem.system.coefficients();
  const int degree = basis.degree() + 3;
  DisplacementOperators operators;
  for (int span = 0; span < basis.span_count(); ++span) {
    std::vector<double> points{basis.breaks()[span]};
    for (const double cut : cuts) {
      if (cut > points.back() && cut < basis.breaks()[span + 1]) points.push_back(cut);
    }
    points.push_back(basis.breaks()[span + 1]);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const numerics::Interval from = points[i], to = points[i + 1];
      operators.pieces.push_back({span, points[i], points[i + 1]});
      auto& factors = operators.factors.emplace_back();
      const auto rows = numerics::bezier_extraction<numerics::Interval>(basis, span, from, to);
      const numerics::BernsteinCoefficients force = bernstein_on_segment(
          std::array{0.0, c.stiffness, 0.0, c.cubic}, numerics::Interval(0), from, to);
      for (int l = 0; l < rows.rows(); ++l) {
        const numerics::BernsteinCoefficients value(rows.row(l).begin(), rows.row(l).end());
        factors[0].push_back(elevate_degree(value, degree));
        factors[2].push_back(bernstein_product(force, value));
      }
      for (const numerics::BernsteinCoefficients& slope :
           partial_sum_slopes(basis, span, from, to)) {
        factors[1].push_back(elevate_degree(slope, degree));
      }
    }
  }
  return operators;
}

}  // namespace fpkcheck::backward
