#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "fd_fpk/axis/grid.hpp"
#include "numerics/polynomials/polynomial.hpp"

/// One-dimensional operators on cell averages. Tensor products of these one-dimensional operators
/// form the Fokker-Planck operator of the phase plane.
namespace fpkcheck::fd_fpk {

using AxisOperator = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// Side of a cell face on which a stencil with an odd number of cells has one cell more than on the
/// opposite side.
enum class UpstreamSideOfFace { left, right };

/// Returns the matrix that maps cell averages to point values on the inner faces 1 .. cells-1,
/// shape (cells + 1, cells). The matrix rows of the two end faces of the axis are zero. Each
/// finite-volume stencil has `stencil_size` cells and is exact for polynomial densities of a degree
/// < stencil_size. Finite-volume stencils with an even number of cells are centred.
AxisOperator face_value_operator(const GridAxis& axis, int stencil_size,
                                 UpstreamSideOfFace upstream_side);

/// Returns the matrix, shape (cells + 1, cells), that maps cell averages to derivatives on the
/// inner faces. Each finite-volume stencil is centred and has an even number `stencil_size` of
/// cells.
AxisOperator face_derivative_operator(const GridAxis& axis, int stencil_size);

/// Kink of a density p at the cell face x = 0, where the force f is discontinuous and the diffusion
/// coefficient is D. The probability flux f p + D p' is continuous, so that p' jumps by -[f] p / D,
/// where [f] is the jump of the force f. Near the kink, the density p satisfies (f p + D p')' = r
/// with a smooth function r. With a = [f] / (2 D), the density is p = q exp(-a |x|) with a
/// continuously differentiable factor q, whose second derivative q'' jumps by 2 a (b q + q') at x =
/// 0, where b D is the mean of the two one-sided forces f.
struct DensityKink {
  double decay = 0;  ///< decay rate a of the factor exp(-a |x|)
  double drift = 0;  ///< coefficient b: b D is the mean of the one-sided forces f
};

/// Return the matrices of face_value_operator() and face_derivative_operator() for densities with a
/// kink at x = 0. Each finite-volume stencil that contains cells on both sides of x = 0 is exact
/// for the functions exp(-a |x|) (1 + a b x |x| / 2), exp(-a |x|) (x + a x |x| / 2) and exp(-a |x|)
/// x^k, k >= 2, instead of polynomials. On the cell face x = 0, an inner face of the axis, the
/// derivative of the density p is the mean of the two one-sided derivatives.
AxisOperator face_value_operator(const GridAxis& axis, int stencil_size,
                                 UpstreamSideOfFace upstream_side, const DensityKink& kink);
AxisOperator face_derivative_operator(const GridAxis& axis, int stencil_size,
                                      const DensityKink& kink);

/// Returns the row vector, shape (1, cells), that extrapolates the cell averages of a function to
/// the value of the function at an end of the axis.
AxisOperator end_value_operator(const GridAxis& axis, AxisEnd end, int stencil_size);

/// Returns the matrix that maps the cell averages of a density p to the cell averages of the
/// product weight(x) p, shape (cells, cells). Each finite-volume stencil has an odd number
/// `stencil_size` of cells and does not cross the inner cell face `barrier`.
AxisOperator weighted_average_operator(const GridAxis& axis, int stencil_size,
                                       const numerics::Polynomial& weight,
                                       std::optional<int> barrier = {});

/// Computes the matrices of weighted_average_operator() for weight functions that are not
/// polynomials. The quadrature over a cell is exact for polynomial weight functions of degree up to
/// 19 minus the degree of the reconstructed density. The constructor of
/// WeightedAverageMatrixBuilder solves the linear systems for the stencil coefficients once, since
/// these systems do not depend on the weight function.
class WeightedAverageMatrixBuilder {
 public:
  /// @param axis grid axis, which must outlive this WeightedAverageMatrixBuilder
  WeightedAverageMatrixBuilder(const GridAxis& axis, int stencil_size,
                               std::optional<int> barrier = {});

  AxisOperator weighted_average_matrix(const std::function<double(double)>& weight) const;

 private:
  struct Stencil {
    int first;  ///< first cell of the stencil
    /// Matrix that maps the values of the weight function at the quadrature points of a cell to the
    /// stencil coefficients of the weighted average
    Eigen::MatrixXd stencil_weights_of_values;
  };
  const GridAxis& axis_;
  std::vector<Stencil> stencils_;  ///< one for each cell of the axis
};

/// Returns the matrix, shape (n cells, cells), that maps the cell averages of a function to values
/// at n points of each cell. Matrix row i n + k gives the value of the function at face(i) +
/// fractions[k] width(i). The matrix of point values uses the stencils of
/// weighted_average_operator().
AxisOperator point_value_operator(const GridAxis& axis, int stencil_size,
                                  std::span<const double> fractions,
                                  std::optional<int> barrier = {});

/// Returns the matrix, shape (cells, cells + 1), that maps the values F[f] of a flux on the cell
/// faces to the divergence (F[f+1] - F[f]) / width in the cells.
AxisOperator divergence_operator(const GridAxis& axis);

constexpr int centred_stencil_size(int order) { return order + order % 2; }

/// Returns the smallest stencil size of weighted_average_operator(), in cells, that suffices for a
/// finite-volume scheme of the given order. Weighted averages from a stencil of n cells are
/// accurate to order n + 1.
constexpr int averaging_stencil_size(int order) { return order % 2 == 1 ? order : order - 1; }

}  // namespace fpkcheck::fd_fpk
