#include "numerics/splines/spline_basis.hpp"

#include <algorithm>
#include <cmath>

#include "numerics/roots/bracketed_root.hpp"

namespace fpkcheck::numerics {

SplineBasis::SplineBasis(std::vector<double> breaks, int degree)
    : breaks_(std::move(breaks)), degree_(degree) {
  knots_.assign(degree_, breaks_.front());
  knots_.insert(knots_.end(), breaks_.begin(), breaks_.end());
  knots_.insert(knots_.end(), degree_, breaks_.back());
}

int SplineBasis::knot_span_containing(double x) const {
  const auto after = std::upper_bound(breaks_.begin() + 1, breaks_.end() - 1, x);
  return static_cast<int>(after - breaks_.begin()) - 1;
}

Eigen::MatrixXd SplineBasis::basis_derivatives(double x, int span, int derivatives) const {
  const double begin = breaks_[span], width = breaks_[span + 1] - begin, t = (x - begin) / width;
  Eigen::MatrixXd rows = bezier_extraction<double>(*this, span, begin, begin + width);
  Eigen::MatrixXd values = Eigen::MatrixXd::Zero(derivatives + 1, degree_ + 1);
  double scale = 1;  // factor p (p-1) .. / width^d of derivative d
  for (int d = 0; d <= std::min(derivatives, degree_); ++d) {
    Eigen::MatrixXd b = rows;  // intermediate points of de Casteljau's algorithm
    for (int n = degree_ - d; n > 0; --n) {
      b = ((1 - t) * b.leftCols(n) + t * b.middleCols(1, n)).eval();
    }
    values.row(d) = scale * b.col(0).transpose();
    const Eigen::Index n = rows.cols() - 1;
    if (n == 0) break;
    rows = (rows.rightCols(n) - rows.leftCols(n)).eval();
    scale *= static_cast<double>(n) / width;
  }
  return values;
}

std::vector<double> graded_break_points(double end, int cells, double finest, double uniform_from) {
  // The number of graded cells between 0 and x is proportional to int_0^x (1 + t/uniform_from)/(t +
  // finest) dt.
  const auto count = [&](double x) {
    return x / uniform_from + (1 - finest / uniform_from) * std::log1p(x / finest);
  };
  std::vector<double> breaks(cells + 1);
  for (int i = 1; i < cells; ++i) {
    const double wanted = count(end) * i / cells;
    breaks[i] = bracketed_root([&](double x) { return count(x) - wanted; }, breaks[i - 1], end);
  }
  breaks[cells] = end;
  return breaks;
}

}  // namespace fpkcheck::numerics
