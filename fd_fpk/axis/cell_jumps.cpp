#include "fd_fpk/axis/cell_jumps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "problem/impulse_law.hpp"

namespace fpkcheck::fd_fpk {
namespace {

// Gauss-Legendre rule with four points on [-1/2, 1/2].
struct Node {
  double at;
  double weight;
};
constexpr std::array kNodes{Node{-0.43056815579702629, 0.17392742256872693},
                            Node{-0.16999052179242813, 0.32607257743127307},
                            Node{0.16999052179242813, 0.32607257743127307},
                            Node{0.43056815579702629, 0.17392742256872693}};

// The upper end of a cell; infinity for the last cell, which receives all mass above the axis.
double upper_end(const Axis& axis, int cell) {
  return cell + 1 < axis.cell_count() ? axis.face_position(cell + 1)
                                      : std::numeric_limits<double>::infinity();
}

// Adds the jumps by a law with a density, by quadrature over four points of the source cell.
void add_density_jumps(const Axis& axis, const problem::ImpulseLaw& law, int from,
                       CellJumpMatrices& jumps) {
  for (const auto& [at, weight] : kNodes) {
    const double offset = at * axis.cell_width(from);
    const double v = axis.cell_centre(from) + offset;
    double below = 0;
    for (int to = 0; to < axis.cell_count(); ++to) {
      const double end = upper_end(axis, to);
      const double until = std::isinf(end) ? 1 : law.cumulative_probability(end - v);
      jumps.uniform(to, from) += weight * (until - below);
      jumps.slope(to, from) += weight * offset * (until - below);
      below = until;
    }
  }
}

// Adds the jumps by an atom of the law. The atom shifts the mass of the whole source cell; each
// target cell receives the fraction that overlaps with the target cell.
void add_atom_jumps(const Axis& axis, const problem::AmplitudeAtom& atom, int from,
                    CellJumpMatrices& jumps) {
  const double left = axis.face_position(from) + atom.amplitude;
  const double right = axis.face_position(from + 1) + atom.amplitude;
  const double centre = axis.cell_centre(from) + atom.amplitude;
  for (int to = 0; to < axis.cell_count(); ++to) {
    const double begin =
        std::max(left, to == 0 ? -std::numeric_limits<double>::infinity() : axis.face_position(to));
    const double end = std::min(right, upper_end(axis, to));
    if (!(end > begin)) continue;
    const double share = atom.probability * (end - begin) / (right - left);
    jumps.uniform(to, from) += share;
    jumps.slope(to, from) += share * ((begin + end) / 2 - centre);
  }
}

}  // namespace

CellJumpMatrices cell_jump_matrices(const Axis& axis, const problem::ImpulseLaw& law) {
  const int cells = axis.cell_count();
  CellJumpMatrices jumps{.uniform = Eigen::MatrixXd::Zero(cells, cells),
                         .slope = Eigen::MatrixXd::Zero(cells, cells)};
  const auto atoms = law.atoms();
  for (int from = 0; from < cells; ++from) {
    if (atoms.empty()) add_density_jumps(axis, law, from, jumps);
    for (const auto& atom : atoms) add_atom_jumps(axis, atom, from, jumps);
  }
  return jumps;
}

}  // namespace fpkcheck::fd_fpk
