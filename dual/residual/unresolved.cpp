#include "dual/residual/unresolved.hpp"

#include <cstddef>

#include "dual/control/generator_factors.hpp"
#include "dual/control/impulse_means.hpp"
#include "dual/spline/gauss_rule.hpp"

namespace fpkcheck::dual {
namespace {

constexpr int kPerCell = 2;  // points along an axis

/// Values of f at all points of both axes.
Eigen::MatrixXd values_of(const SeparableFunction& f, std::span<const double> y,
                          std::span<const double> v) {
  const auto along = [](const std::function<double(double)>& g, std::span<const double> points) {
    Eigen::VectorXd values(std::ssize(points));
    for (Eigen::Index n = 0; n < values.size(); ++n) {
      values(n) = g(points[static_cast<std::size_t>(n)]);
    }
    return values;
  };
  return along(f.of_y, y) * along(f.of_v, v).transpose();
}

}  // namespace

Unresolved::Unresolved(const problem::Problem& problem, const WeakResiduals& residuals,
                       std::span<const SeparableFunction> functions, const ControlFunctions& h) {
  const KnotSplines &ys = residuals.y(), &vs = residuals.v();
  const auto y = gauss_rule<kPerCell>(ys.breaks()).points;
  const auto v = gauss_rule<kPerCell>(vs.breaks()).points;
  const GeneratorFactors of_y = factors_of_y(problem.system, ys, y);
  const GeneratorFactors of_v =
      factors_of_v(problem, vs, v, impulse_means(vs, problem.impulses, v));
  const auto walls = impact_walls(problem.system);
  std::vector<Eigen::MatrixXd> jumps;

  const Eigen::Index ny = std::ssize(y) / kPerCell, nv = std::ssize(v) / kPerCell;
  const auto count = static_cast<Eigen::Index>(functions.size());
  in_cells_.resize(ny * nv, count);
  for (const ImpactWall& wall : walls) {
    const auto u = gauss_rule<kPerCell>(breaks_of_jumps(vs, wall)).points;
    jumps.push_back(jumps_at(vs, wall, u));
    at_walls_.emplace_back(std::ssize(u) / kPerCell, count);
  }
  for (Eigen::Index k = 0; k < count; ++k) {
    const auto at = static_cast<std::size_t>(k);
    const Eigen::MatrixXd coefficients =
        h.coefficients.col(k).reshaped<Eigen::RowMajor>(ys.size(), vs.size());
    Eigen::MatrixXd left = values_of(functions[at], y, v).array() - h.means[at];
    for (std::size_t term = 0; term < of_y.size(); ++term) {
      left.noalias() += of_y[term] * coefficients * of_v[term].transpose();
    }
    for (Eigen::Index i = 0; i < ny; ++i) {
      for (Eigen::Index j = 0; j < nv; ++j) {
        in_cells_(i * nv + j, k) =
            left.block<kPerCell, kPerCell>(i * kPerCell, j * kPerCell).cwiseAbs().mean();
      }
    }
    for (std::size_t n = 0; n < walls.size(); ++n) {
      const Eigen::Index row = walls[n].away > 0 ? 0 : coefficients.rows() - 1;
      const Eigen::VectorXd jump = jumps[n] * coefficients.row(row).transpose();
      for (Eigen::Index i = 0; i < at_walls_[n].rows(); ++i) {
        at_walls_[n](i, k) = jump.segment<kPerCell>(i * kPerCell).cwiseAbs().mean();
      }
    }
  }
}

Eigen::VectorXd Unresolved::of(const WeakForm& density) const {
  const Eigen::VectorXd masses = density.cells.reshaped<Eigen::RowMajor>().cwiseAbs();
  Eigen::VectorXd sums = in_cells_.transpose() * masses;
  for (std::size_t n = 0; n < at_walls_.size(); ++n) {
    sums += at_walls_[n].transpose() * density.impacts[n].cwiseAbs();
  }
  return sums;
}

}  // namespace fpkcheck::dual
