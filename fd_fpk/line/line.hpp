#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace fpkcheck::fd_fpk {

/// What lies beyond an end of a line: nothing (p = 0 there, an outer wall of the box), or a
/// boundary across which p must not be continued (an impact wall), so that stencils are shifted
/// inwards.
enum class Beyond { vacuum, boundary };

/// A line cut into cells: `cells() + 1` increasing faces.
class Line {
 public:
  explicit Line(std::vector<double> faces, Beyond left = Beyond::vacuum,
                Beyond right = Beyond::vacuum);
  /// `cells` cells of width `step`; the first begins at `origin`.
  static Line uniform(double origin, double step, int cells, Beyond left = Beyond::vacuum);

  int cells() const { return static_cast<int>(faces_.size()) - 1; }
  /// Position of a face. Faces before the first and after the last continue the line with cells as
  /// wide as the one at that end, for stencils that reach into the vacuum.
  double face(int f) const;
  double centre(int i) const { return (face(i) + face(i + 1)) / 2; }
  double width(int i) const { return face(i + 1) - face(i); }
  double smallest_width() const;

  Beyond left() const { return left_; }
  Beyond right() const { return right_; }
  const std::vector<double>& faces() const { return faces_; }
  Eigen::VectorXd widths() const;
  /// The line that begins at an inner face, with vacuum on both sides.
  Line from(int first_face) const;

 private:
  std::vector<double> faces_;
  Beyond left_, right_;
};

/// How cells grow away from x = 0. The number of cells up to x is proportional to
///
///     x + reach log(1 + x / core),
///
/// so that far out the width is h, at the origin h / (1 + reach/core), and between them it grows by
/// about h/reach from cell to cell. reach = 0 is a uniform line.
struct Grading {
  double reach = 0;
  double core = 1;
};

/// Faces 0 = x_0 < ... < x_cells = length, graded towards 0.
std::vector<double> graded_faces(double length, int cells, const Grading& grading);

/// Where cells shrink.
struct Centre {
  double x;
  Grading grading;
};

/// Faces from `from` to `to` on which every centre between lies, graded towards each of them; cells
/// are `step` wide far from all.
/// @param centres increasing
std::vector<double> faces_graded_to(double from, double to, double step,
                                    std::span<const Centre> centres);

/// Cells that graded_faces needs for cells of width `step` far from the origin, not rounded.
double graded_cells(double length, double step, const Grading& grading);

}  // namespace fpkcheck::fd_fpk
