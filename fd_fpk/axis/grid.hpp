#pragma once

#include <Eigen/Core>
#include <functional>
#include <span>
#include <vector>

#include "transform/joint_density.hpp"

namespace fpkcheck::fd_fpk {

enum class AxisEnd { left, right };

/// Condition at an end of a grid axis. The end condition `vacuum`, at an edge of the computational
/// box, sets the density outside the computational box to zero. The end condition `boundary`, at an
/// impact wall, shifts finite-volume stencils inwards. The end condition `barrier`, for
/// first-passage problems, absorbs all motion that reaches the right end of the axis.
enum class AxisEndCondition { vacuum, boundary, barrier };

class GridAxis {
 public:
  explicit GridAxis(std::vector<double> faces, AxisEndCondition left = AxisEndCondition::vacuum,
                    AxisEndCondition right = AxisEndCondition::vacuum);
  /// Returns a grid axis from `origin` with `cell_count` cells of the width `cell_width`.
  static GridAxis with_uniform_cells(
      double origin, double cell_width, int cell_count,
      AxisEndCondition left_end_condition = AxisEndCondition::vacuum);

  int cell_count() const { return static_cast<int>(faces_.size()) - 1; }
  /// Returns the position of a cell face. A face index beyond the ends of the grid axis refers to
  /// empty cells outside the axis, which are as wide as the outermost cell.
  double face_position(int face) const;
  double cell_centre(int cell) const { return (face_position(cell) + face_position(cell + 1)) / 2; }
  double cell_width(int cell) const { return face_position(cell + 1) - face_position(cell); }
  double smallest_cell_width() const;

  AxisEndCondition left_end_condition() const { return left_; }
  AxisEndCondition right_end_condition() const { return right_; }
  const std::vector<double>& faces() const { return faces_; }
  Eigen::VectorXd cell_widths() const;
  /// Returns a copy of this grid axis with the given condition at the right end.
  GridAxis with_right_end_condition(AxisEndCondition condition) const {
    return GridAxis(faces_, left_, condition);
  }
  /// Returns the part of this grid axis above an inner cell face, with the end condition `vacuum`
  /// at both ends.
  GridAxis subaxis_above_face(int first_face) const;

 private:
  std::vector<double> faces_;
  AxisEndCondition left_, right_;
};

/// Parameters of a graded axis, whose cells become narrower towards x = 0. The number of graded
/// cells between 0 and x is proportional to
///
///     x + reach log(1 + x / core).
///
/// On a graded axis with the cell width h far from the origin, the cell width at the origin is h /
/// (1 + reach/core), and the ratio of neighbouring cell widths is at most about 1 + h/reach. The
/// value reach = 0 of the cell grading gives cells of equal width.
struct CellGrading {
  double reach = 0;
  double core = 1;
};

/// Returns the faces 0 = x_0 < ... < x_cells = length of an axis with cells graded towards 0.
std::vector<double> graded_cell_faces(double length, int cells, const CellGrading& grading);

/// Point of a grid axis towards which the cell widths decrease.
struct RefinementPoint {
  double x;
  CellGrading grading;
};

/// Returns the positions of cell faces between `from` and `to`. Every refinement point between
/// `from` and `to` is a cell face. Far from all refinement points, the function `stretched` of the
/// position increases by `step` over each cell.
/// @param refinement_points refinement points in the order of increasing positions
/// @param stretched increasing function of the position; by default the position itself, which
/// gives cells of equal width far from the refinement points
std::vector<double> cell_faces_graded_to_points(
    double from, double to, double step, std::span<const RefinementPoint> refinement_points,
    const std::function<double(double)>& stretched = [](double x) { return x; });

/// Returns the unrounded number of cells of a graded axis whose cells have the width `step` far
/// from the origin.
double graded_cell_count(double length, double step, const CellGrading& grading);

/// Returns the positions of cell faces that include all given positions `anchors`. Each interval
/// between two anchors is divided into a whole number of cells, which are slightly narrower than
/// the prescribed function `width`.
/// @param anchors given positions of cell faces in increasing order, at least two
/// @param width function that returns the prescribed cell width > 0 at a position. The relative
/// change of the prescribed cell width over one cell must be small.
std::vector<double> cell_faces_from_width_function(std::span<const double> anchors,
                                                   const std::function<double(double)>& width);

/// Grid of rectangular cells on x1 in [x1_min, x1_max] and x2 in [-x2_max, x2_max]. If the problem
/// has a wall, x1_min is 0. For an oscillator with one wall the grid covers the half z >= 0 of the
/// (z, z') plane, since the density p(z, z') is point-symmetric. The cell faces of the velocity
/// axis x2 are symmetric about 0 and include 0. The unknowns of the density equation are the
/// averages of p(y, y') = 2 p(z, z') over the grid cells; cell (i, j) has the index i
/// v_cell_count() + j.
struct PhasePlaneGrid {
  GridAxis
      x1;  ///< axis of displacement, with an impact wall at each end with the condition `boundary`
  GridAxis x2;

  int nx() const { return x1.cell_count(); }
  int v_cell_count() const { return x2.cell_count(); }  ///< number of cells of x2, always even
  int size() const { return nx() * v_cell_count(); }
  double x1_min() const { return x1.faces().front(); }
  double x1_max() const { return x1.faces().back(); }
  double x2_max() const { return x2.faces().back(); }
  Eigen::VectorXd cell_areas() const;
  /// Returns the axis of speeds, the half x2 >= 0 of the velocity axis x2.
  GridAxis speed_axis() const { return x2.subaxis_above_face(v_cell_count() / 2); }
};

/// @param positive_x2_faces cell faces with x2 >= 0, increasing from 0; the function adds the
/// mirror images with x2 < 0
/// @param left,right conditions at the two ends of the displacement axis x1
PhasePlaneGrid symmetric_grid(std::vector<double> x1_faces,
                              const std::vector<double>& positive_x2_faces,
                              AxisEndCondition left = AxisEndCondition::boundary,
                              AxisEndCondition right = AxisEndCondition::vacuum);

/// @param nx,nv numbers of cells in the displacement x1 and the velocity x2; nv must be even
PhasePlaneGrid make_grid(int nx, int nv, double x1_max, double x2_max,
                         const CellGrading& x1_grading = {}, const CellGrading& x2_grading = {});

transform::GridDensity grid_density_from_averages(const PhasePlaneGrid& grid,
                                                  const Eigen::VectorXd& cell_averages);

/// Largest density along each edge of the computational box, divided by a peak density.
struct BoxEdgeDensity {
  double x1;
  double x2;
  double x1_low = 0;  ///< density along the left end of x1; 0 at an impact wall
};

/// @param peak_density peak density, by which the returned densities are divided
BoxEdgeDensity box_edge_density(const PhasePlaneGrid& grid, const Eigen::VectorXd& cell_averages,
                                double peak_density);

}  // namespace fpkcheck::fd_fpk
