#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace fpkcheck::fd_fpk {

/// Continuation of a density across an end of an axis. vacuum: p = 0 outside (a wall of the box).
/// boundary: p must not be continued (an impact wall), so that stencils are shifted inwards.
enum class EndCondition { vacuum, boundary };

/// An axis divided into cells: `cells() + 1` increasing faces.
class Axis {
 public:
  explicit Axis(std::vector<double> faces, EndCondition left = EndCondition::vacuum,
                EndCondition right = EndCondition::vacuum);
  /// `cells` cells of width `step`, of which the first begins at `origin`.
  static Axis uniform(double origin, double step, int cells,
                      EndCondition left = EndCondition::vacuum);

  int cells() const { return static_cast<int>(faces_.size()) - 1; }
  /// Position of a face. Indices below the first and above the last face continue the axis with
  /// cells as wide as the cell at that end, for stencils that extend into the vacuum.
  double face(int f) const;
  double centre(int i) const { return (face(i) + face(i + 1)) / 2; }
  double width(int i) const { return face(i + 1) - face(i); }
  double smallest_width() const;

  EndCondition left() const { return left_; }
  EndCondition right() const { return right_; }
  const std::vector<double>& faces() const { return faces_; }
  Eigen::VectorXd widths() const;
  /// The part of the axis from an inner face upwards, with vacuum at both ends.
  Axis from(int first_face) const;

 private:
  std::vector<double> faces_;
  EndCondition left_, right_;
};

/// Grading of cells towards x = 0. The number of cells up to x is proportional to
///
///     x + reach log(1 + x / core).
///
/// With h the width far out, the width at the origin is h / (1 + reach/core), and between them the
/// width increases by about h/reach from cell to cell. reach = 0 is a uniform axis.
struct Grading {
  double reach = 0;
  double core = 1;
};

/// Faces 0 = x_0 < ... < x_cells = length, graded towards 0.
std::vector<double> graded_faces(double length, int cells, const Grading& grading);

/// A point towards which cells shrink.
struct RefinementPoint {
  double x;
  Grading grading;
};

/// Faces from `from` to `to` that include every refinement point between, graded towards each of
/// them; far from all the cells have the width `step`.
/// @param refinement_points increasing
std::vector<double> faces_graded_to(double from, double to, double step,
                                    std::span<const RefinementPoint> refinement_points);

/// Number of cells (not rounded) of graded_faces with width `step` far from the origin.
double graded_cell_count(double length, double step, const Grading& grading);

}  // namespace fpkcheck::fd_fpk
