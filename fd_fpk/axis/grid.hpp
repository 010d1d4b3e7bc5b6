#pragma once

#include <Eigen/Core>
#include <functional>
#include <span>
#include <vector>

#include "transform/density.hpp"

namespace fpkcheck::fd_fpk {

/// The left or the right end of the x1 axis.
enum class AxisEnd { left, right };

/// Condition that continues a density across an end of an axis. `vacuum`: the density is zero
/// outside the axis (an end of the box). `boundary`: the density has no continuation (an impact
/// wall), so that stencils near the end are shifted inwards.
enum class EndCondition { vacuum, boundary };

/// An axis divided into cells by `cell_count() + 1` increasing faces.
class Axis {
 public:
  explicit Axis(std::vector<double> faces, EndCondition left = EndCondition::vacuum,
                EndCondition right = EndCondition::vacuum);
  /// An axis with `cells` cells of width `step`. The first cell begins at `origin`.
  static Axis with_uniform_cells(double origin, double step, int cells,
                                 EndCondition left = EndCondition::vacuum);

  int cell_count() const { return static_cast<int>(faces_.size()) - 1; }
  /// Position of a face of the axis. For stencils that extend into the vacuum, face indices below
  /// the first and above the last face belong to cells outside the axis, which are as wide as the
  /// outermost cell.
  double face_position(int f) const;
  double cell_centre(int i) const { return (face_position(i) + face_position(i + 1)) / 2; }
  double cell_width(int i) const { return face_position(i + 1) - face_position(i); }
  double smallest_cell_width() const;

  EndCondition left_end_condition() const { return left_; }
  EndCondition right_end_condition() const { return right_; }
  const std::vector<double>& faces() const { return faces_; }
  Eigen::VectorXd cell_widths() const;
  /// The part of the axis above an inner face, with the condition `vacuum` at its two ends.
  Axis part_from_face(int first_face) const;

 private:
  std::vector<double> faces_;
  EndCondition left_, right_;
};

/// Parameters of cells whose width decreases towards x = 0. The number of cells between 0 and x is
/// proportional to
///
///     x + reach log(1 + x / core).
///
/// With h the cell width far from the origin, the cell width at the origin is h / (1 + reach/core).
/// Between the origin and the wide cells the ratio of neighbouring cell widths is about 1 +
/// h/reach. The value reach = 0 gives a uniform axis.
struct Grading {
  double reach = 0;
  double core = 1;
};

/// Faces 0 = x_0 < ... < x_cells = length of an axis with cells graded towards 0.
std::vector<double> graded_faces(double length, int cells, const Grading& grading);

/// A point towards which the cell widths decrease.
struct RefinementPoint {
  double x;
  Grading grading;
};

/// Faces from `from` to `to`, which include every refinement point in that interval. The cell width
/// decreases towards each refinement point, and is `step` far from all refinement points.
/// @param refinement_points refinement points, by increasing position
std::vector<double> faces_graded_to_points(double from, double to, double step,
                                           std::span<const RefinementPoint> refinement_points);

/// Number of cells (not rounded) of an axis with graded_faces whose cells have the width `step` far
/// from the origin.
double graded_cell_count(double length, double step, const Grading& grading);

/// Faces of an axis that include all anchors. Each cell is slightly narrower than the function
/// `width` prescribes at its position, so that a whole number of cells fills each interval between
/// anchors.
/// @param anchors positions in increasing order, at least two
/// @param width function that returns the cell width at a position, > 0. The relative change of the
/// prescribed width over one cell must be small.
std::vector<double> faces_with_local_width(std::span<const double> anchors,
                                           const std::function<double(double)>& width);

/// Grid of rectangular cells on x1 in [x1_min, x1_max], x2 in [-x2_max, x2_max]. If the problem has
/// a wall, x1_min is 0. For the paper's oscillator the grid covers one half of the (z, z') plane;
/// the density on the other half follows by point symmetry. The line x2 = 0 is a face of the cells,
/// and the faces of x2 are symmetric about 0. The unknown is the average of p(y, y') (= 2 p(z, z')
/// of the paper) over each cell; cell (i, j) has index i nv() + j.
struct Grid {
  Axis x1;  ///< an end with the condition `boundary` is an impact wall
  Axis x2;

  int nx() const { return x1.cell_count(); }
  int nv() const { return x2.cell_count(); }  ///< even
  int size() const { return nx() * nv(); }
  double x1_min() const { return x1.faces().front(); }
  double x1_max() const { return x1.faces().back(); }
  double x2_max() const { return x2.faces().back(); }
  /// Areas of all cells, shape (size).
  Eigen::VectorXd cell_areas() const;
  /// The axis of speeds: the half x2 >= 0 of the velocity axis, in increasing order from 0.
  Axis speed_axis() const { return x2.part_from_face(nv() / 2); }
};

/// @param positive_x2_faces faces of x2 >= 0, increasing from 0; the function adds their mirror
/// images
/// @param left,right end conditions of x1
Grid symmetric_grid(std::vector<double> x1_faces, const std::vector<double>& positive_x2_faces,
                    EndCondition left = EndCondition::boundary,
                    EndCondition right = EndCondition::vacuum);

/// @param nx,nv numbers of cells in x1 and x2; nv even
Grid make_grid(int nx, int nv, double x1_max, double x2_max, const Grading& x1_grading = {},
               const Grading& x2_grading = {});

/// The density on the grid that has the given cell averages.
transform::GridDensity grid_density(const Grid& grid, const Eigen::VectorXd& averages);

/// The largest density in the cells along each end of the box in x1 and in x2, relative to a peak
/// density. The value at an end of the box that is an impact wall is zero.
struct WallDensity {
  double x1;
  double x2;
  double x1_low = 0;  ///< density along the left end of the box; 0 if that end is an impact wall
};

/// @param reference the peak density: the returned wall densities are fractions of this value
WallDensity wall_density(const Grid& grid, const Eigen::VectorXd& averages, double reference);

}  // namespace fpkcheck::fd_fpk
