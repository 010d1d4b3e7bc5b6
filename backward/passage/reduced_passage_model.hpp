#pragma once

#include <Eigen/Core>

namespace fpkcheck::backward {

/// Reduced model of the survival probability S(x, t) = P_x(tau > t) of all starts x. Let L be the
/// generator of the process that ends at the barrier. The Laplace transform u_p of S satisfies
/// L u_p = p u_p - 1. The model is the Galerkin projection of L to the span of such functions for
/// several real p (rational Krylov method: Ruhe, Linear Algebra Appl. 58 (1984) 391; Druskin and
/// Simoncini, Systems & Control Letters 60 (2011) 546). The projection is orthogonal for the values
/// at the nodes of the mean over an impulse. The reduced model has exact values u_p at each p.
class ReducedOrderPassageModel {
 public:
  /// @param node_count number of nodes
  /// @param functional_count number of linear functionals of S, such as its value at a start
  ReducedOrderPassageModel(Eigen::Index node_count, Eigen::Index functional_count)
      : node_count_(node_count), functional_count_(functional_count) {}

  /// Function u with L u = shift u - source 1 - u_previous.
  struct BasisFunction {
    Eigen::VectorXd node_values;  ///< means of u over an impulse at the nodes
    Eigen::VectorXd functionals;  ///< values of the functionals of u
    double shift = 0;
    double source = 1;          ///< 1 for Laplace transforms, 0 for eigenfunctions
    bool has_previous = false;  ///< whether u_previous is the function that was added last
  };
  void add_basis_function(const BasisFunction& function);

  /// Modes of the functionals f: f(S(., t)) is the real part of the sum over k of
  /// coefficients(f, k) exp(rates(k) t). Modes that do not decay are artefacts and are omitted.
  struct Modes {
    Eigen::VectorXcd rates;
    Eigen::MatrixXcd coefficients;  ///< shape (functionals, modes)
  };
  Modes compute_modes() const;

 private:
  Eigen::Index node_count_, functional_count_;
  // Columns: the functions of the basis, divided by the norms of their values at the nodes. The
  // matrix `images_` represents L by L V = V images_ - 1 sources_.
  Eigen::MatrixXd node_values_, functionals_, images_;
  Eigen::RowVectorXd sources_;
  double last_norm_ = 1;
};

}  // namespace fpkcheck::backward
