#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "fd_fpk/axis/grid.hpp"
#include "numerics/polynomials/polynomial.hpp"

/// One-dimensional operators on cell averages, whose tensor products form the operator of the
/// plane.
namespace fpkcheck::fd_fpk {

using AxisOperator = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// Side of a face on which a stencil with an odd number of cells has one cell more than on the
/// other side.
enum class UpstreamSideOfFace { left, right };

/// Returns the matrix that maps cell averages to point values on the inner faces 1 .. cells-1,
/// shape (cells + 1, cells). The matrix rows of the two end faces of the axis are zero. Each
/// finite-volume stencil has `stencil_size` cells and is exact for polynomial densities of a degree
/// below stencil_size. Finite-volume stencils with an even number of cells are centred.
AxisOperator face_value_operator(const GridAxis& axis, int stencil_size,
                                 UpstreamSideOfFace upstream_side);

/// Returns the matrix, shape (cells + 1, cells), that maps cell averages to derivatives on the
/// inner faces. Each finite-volume stencil is centred and has an even number `stencil_size` of
/// cells.
AxisOperator face_derivative_operator(const GridAxis& axis, int stencil_size);

/// Kink of a density p at the face x = 0, at which a force f jumps under the diffusion D. The
/// probability flux f p + D p' is continuous, so that p' jumps by -[f] p / D, where [f] is the jump
/// of the force f. The density p satisfies (f p + D p')' = r with a smooth function r. Therefore p
/// = q exp(-a |x|) with a = [f] / (2 D), where q'' jumps by 2 a (b q + q') at x = 0 and b D is the
/// mean of the two one-sided forces f.
struct DensityKink {
  double decay = 0;  ///< decay rate a of the factor exp(-a |x|)
  double drift = 0;  ///< coefficient b: b D is the mean of the one-sided forces f
};

/// Return the matrices of face_value_operator() and face_derivative_operator() for densities with a
/// kink at x = 0. Each finite-volume stencil that contains cells on both sides of x = 0 is exact
/// for the functions exp(-a |x|) (1 + a b x |x| / 2), exp(-a |x|) (x + a x |x| / 2) and exp(-a |x|)
/// x^k, k >= 2, instead of polynomials. On the cell face x = 0 the derivative is the mean of the
/// two one-sided derivatives. The position x = 0 must be an inner cell face of the axis.
AxisOperator face_value_operator(const GridAxis& axis, int stencil_size,
                                 UpstreamSideOfFace upstream_side, const DensityKink& kink);
AxisOperator face_derivative_operator(const GridAxis& axis, int stencil_size,
                                      const DensityKink& kink);

/// Returns the row vector that extrapolates cell averages to the point value at an end of the axis,
/// shape (1, cells).
AxisOperator end_value_operator(const GridAxis& axis, AxisEnd end, int stencil_size);

/// Returns the matrix that maps averages of p over cells to averages of weight(x) p, shape (cells,
/// cells). Stencils have an odd number `stencil_size` of cells and do not cross the inner face
/// `barrier`.
AxisOperator weighted_average_operator(const GridAxis& axis, int stencil_size,
                                       const numerics::Polynomial& weight,
                                       std::optional<int> barrier = {});

/// Computes the matrices of weighted_average_operator() for weights that are no polynomials. The
/// integrals over a cell are exact for weights of degree 19 minus the degree of the reconstruction.
/// The constructor of WeightedAverageMatrixBuilder solves the linear systems for the stencil
/// coefficients once, since these systems do not depend on the weight function.
class WeightedAverageMatrixBuilder {
 public:
  /// @param axis must outlive this object
  WeightedAverageMatrixBuilder(const GridAxis& axis, int stencil_size,
                               std::optional<int> barrier = {});

  AxisOperator weighted_average_matrix(const std::function<double(double)>& weight) const;

 private:
  struct Stencil {
    int first;  ///< first cell of the stencil
    /// Matrix that maps the values of the weight at the quadrature points of the cell to the
    /// weights of the stencil
    Eigen::MatrixXd stencil_weights_of_values;
  };
  const GridAxis& axis_;
  std::vector<Stencil> stencils_;  ///< one for each cell of the axis
};

/// Returns the matrix that maps cell averages to point values inside the cells, shape (n cells,
/// cells), for n fractions. Matrix row i n + k gives the point value at face(i) + fractions[k]
/// width(i). The matrix of point values uses the stencils of weighted_average_operator().
AxisOperator point_value_operator(const GridAxis& axis, int stencil_size,
                                  std::span<const double> fractions,
                                  std::optional<int> barrier = {});

/// Returns the matrix, shape (cells, cells + 1), of the divergence (F[f+1] - F[f]) / width of face
/// values.
AxisOperator divergence_operator(const GridAxis& axis);

constexpr int centred_stencil_size(int order) { return order + order % 2; }

/// Returns the smallest stencil size of weighted_average_operator, in cells, for a scheme of the
/// given order. Weighted averages from a stencil of n cells are accurate to order n + 1.
constexpr int averaging_stencil_size(int order) { return order % 2 == 1 ? order : order - 1; }

}  // namespace fpkcheck::fd_fpk
