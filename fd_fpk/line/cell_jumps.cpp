#include "fd_fpk/line/cell_jumps.hpp"

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

// The upper end of a cell; the last cell extends to infinity.
double upper_end(const Line& line, int cell) {
  return cell + 1 < line.cells() ? line.face(cell + 1) : std::numeric_limits<double>::infinity();
}

// For a law with a density: quadrature over four points of the source cell.
void add_continuous(const Line& line, const problem::ImpulseLaw& law, int from, CellJumps& jumps) {
  for (const auto& [at, weight] : kNodes) {
    const double offset = at * line.width(from);
    const double v = line.centre(from) + offset;
    double below = 0;
    for (int to = 0; to < line.cells(); ++to) {
      const double end = upper_end(line, to);
      const double until = std::isinf(end) ? 1 : law.cumulative(end - v);
      jumps.even(to, from) += weight * (until - below);
      jumps.tilt(to, from) += weight * offset * (until - below);
      below = until;
    }
  }
}

// An atom shifts the whole cell; the target cells receive the fractions that overlap.
void add_atom(const Line& line, const problem::Atom& atom, int from, CellJumps& jumps) {
  const double left = line.face(from) + atom.amplitude;
  const double right = line.face(from + 1) + atom.amplitude;
  const double centre = line.centre(from) + atom.amplitude;
  for (int to = 0; to < line.cells(); ++to) {
    const double begin =
        std::max(left, to == 0 ? -std::numeric_limits<double>::infinity() : line.face(to));
    const double end = std::min(right, upper_end(line, to));
    if (!(end > begin)) continue;
    const double share = atom.probability * (end - begin) / (right - left);
    jumps.even(to, from) += share;
    jumps.tilt(to, from) += share * ((begin + end) / 2 - centre);
  }
}

}  // namespace

CellJumps cell_jumps(const Line& line, const problem::ImpulseLaw& law) {
  const int cells = line.cells();
  CellJumps jumps{.even = Eigen::MatrixXd::Zero(cells, cells),
                  .tilt = Eigen::MatrixXd::Zero(cells, cells)};
  const auto atoms = law.atoms();
  for (int from = 0; from < cells; ++from) {
    if (atoms.empty()) add_continuous(line, law, from, jumps);
    for (const auto& atom : atoms) add_atom(line, atom, from, jumps);
  }
  return jumps;
}

}  // namespace fpkcheck::fd_fpk
