#include "epc/continuation.hpp"

#include <algorithm>

#include "epc/pseudo_arclength.hpp"
#include "epc/support.hpp"

namespace fpkcheck::epc {
namespace {

constexpr int kMaxPoints = 120;

// Q_n of the exact density, up to a constant: -(c/D2) (x2^2/2 + k x1^2/2 + mu x1^4/4).
std::vector<Term> elastic_white_noise(const ResidualCoefficients& f) {
  const double beta = f.damping / (f.rate_moment[2] / 2);
  return {{2, 0, -beta * f.stiffness / 2}, {0, 2, -beta / 2}, {4, 0, -beta * f.cubic / 4}};
}

// R at the points of the path of `partway`, in its unit. Linear in the fraction.
Family path_of(const Projection& projection, const ResidualCoefficients& full, double unit) {
  return {
      .residual = [=, &projection](const Eigen::VectorXd& a, double fraction) -> Eigen::VectorXd {
        return projection.residual(partway(full, fraction), a) / unit;
      },
      .jacobian = [=, &projection](const Eigen::VectorXd& a, double fraction) -> Eigen::MatrixXd {
        return projection.jacobian(partway(full, fraction), a) / unit;
      },
      .rate = [=, &projection](const Eigen::VectorXd& a, double) -> Eigen::VectorXd {
        return (projection.residual(full, a) - projection.residual(partway(full, 0), a)) / unit;
      }};
}

BranchEnd end_of(const Curve& curve) {
  switch (curve.end) {
    case CurveEnd::arrived:
      return BranchEnd::full_problem;
    case CurveEnd::returned:
      return BranchEnd::white_noise;
    case CurveEnd::far:
      return BranchEnd::far_away;
    case CurveEnd::stuck:
    case CurveEnd::long_way:
      break;
  }
  return BranchEnd::lost;
}

Branch branch_of(const Curve& curve, const Basis& basis) {
  Branch branch{.end = end_of(curve), .furthest = curve.furthest().t, .points = {}};
  for (const CurvePoint& point : curve.points) {
    branch.points.push_back(
        {.fraction = point.t,
         .norm = point.a.norm(),
         .smallest_singular_value = point.smallest_singular_value,
         .determinant_sign = point.determinant_sign,
         .falls = leading_form(basis.polynomial(point.a), basis.sigma()).negative,
         .fold = false});
  }
  for (const std::size_t fold : curve.folds) branch.points[fold].fold = true;
  return branch;
}

}  // namespace

FollowedBranch follow_branch(const Projection& projection, const ResidualCoefficients& full,
                             double tolerance) {
  const double unit = residual_unit(projection, full);
  const Eigen::VectorXd exact = projection.basis().scaled(elastic_white_noise(full));
  const NewtonResult start = newton(projection, partway(full, 0), exact, {.tolerance = tolerance});
  if (!start.converged) return {{.end = BranchEnd::lost, .furthest = 0, .points = {}}, start};

  const Curve curve = follow(path_of(projection, full, unit), start.a,
                             {.tolerance = tolerance, .max_points = kMaxPoints});
  const CurvePoint& last = curve.end == CurveEnd::arrived ? curve.points.back() : curve.furthest();
  NewtonResult root{
      last.a, projection.residual(partway(full, last.t), last.a).lpNorm<Eigen::Infinity>() / unit,
      0, false};
  if (curve.end == CurveEnd::arrived) {
    root = newton(projection, full, last.a, {.tolerance = tolerance});
  }
  root.iterations += start.iterations + curve.iterations;
  return {branch_of(curve, projection.basis()), root};
}

NewtonResult add_equations(const Projection& projection, const ResidualCoefficients& f,
                           const Eigen::VectorXd& start, double tolerance) {
  const double unit = residual_unit(projection, f);
  const Eigen::VectorXd at_start = projection.residual(f, start) / unit;
  const Family family{
      .residual = [&](const Eigen::VectorXd& a, double t) -> Eigen::VectorXd {
        return projection.residual(f, a) / unit - (1 - t) * at_start;
      },
      .jacobian = [&](const Eigen::VectorXd& a, double) -> Eigen::MatrixXd {
        return projection.jacobian(f, a) / unit;
      },
      .rate = [&](const Eigen::VectorXd&, double) -> Eigen::VectorXd { return at_start; }};
  const Curve curve = follow(family, start, {.tolerance = tolerance, .max_points = kMaxPoints});
  const Eigen::VectorXd& last = curve.points.back().a;
  NewtonResult root{.a = last};
  root.residual = projection.residual(f, last).lpNorm<Eigen::Infinity>() / unit;
  if (curve.end == CurveEnd::arrived) root = newton(projection, f, last, {.tolerance = tolerance});
  root.iterations += curve.iterations;
  return root;
}

}  // namespace fpkcheck::epc
