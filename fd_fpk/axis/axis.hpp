#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace fpkcheck::fd_fpk {

/// Condition that continues a density across an end of an axis. vacuum: p = 0 outside (an end of
/// the box). boundary: p has no continuation (an impact wall), so that stencils near the end are
/// shifted inwards.
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
  /// Position of a face. Indices below the first and above the last face belong to cells outside
  /// the axis, as wide as the outermost cell, for stencils that extend into the vacuum.
  double face_position(int f) const;
  double cell_centre(int i) const { return (face_position(i) + face_position(i + 1)) / 2; }
  double cell_width(int i) const { return face_position(i + 1) - face_position(i); }
  double smallest_cell_width() const;

  EndCondition left_end_condition() const { return left_; }
  EndCondition right_end_condition() const { return right_; }
  const std::vector<double>& faces() const { return faces_; }
  Eigen::VectorXd cell_widths() const;
  /// The part of the axis from an inner face upwards, with vacuum at both ends.
  Axis part_from_face(int first_face) const;

 private:
  std::vector<double> faces_;
  EndCondition left_, right_;
};

/// Grading of cells towards x = 0. The number of cells up to x is proportional to
///
///     x + reach log(1 + x / core).
///
/// With h the cell width far from the origin, the cell width at the origin is h / (1 + reach/core).
/// Between, the ratio of neighbouring cell widths is about 1 + h/reach. reach = 0 is a uniform
/// axis.
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

/// Faces from `from` to `to`, which include every refinement point in that interval. The cells are
/// graded towards each refinement point; far from all refinement points they have the width `step`.
/// @param refinement_points refinement points, by increasing position
std::vector<double> faces_graded_to_points(double from, double to, double step,
                                           std::span<const RefinementPoint> refinement_points);

/// Number of cells (not rounded) of an axis with graded_faces whose cells have the width `step` far
/// from the origin.
double graded_cell_count(double length, double step, const Grading& grading);

}  // namespace fpkcheck::fd_fpk
