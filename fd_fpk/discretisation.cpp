#include "fd_fpk/discretisation.hpp"

#include <algorithm>
#include <cmath>

#include "problem/equivalent_linearisation.hpp"

namespace fpkcheck::fd_fpk {
namespace {

// In deviations of equivalent linearisation. A hardening spring keeps p(y) short, the impulses make
// p(y') long; the steep tail of p(y) in turn wants the finer step.
constexpr double kX1Box = 6;
constexpr double kX2Box = 7;
constexpr double kX1Step = 0.15;
constexpr double kX2Step = 0.17;

// Length that an integer number of velocity steps must cover; 0 where there is none.
double lattice_length(const problem::Problem& problem, const Options& options) {
  switch (options.equation) {
    case Equation::white:
      return 0;
    case Equation::km4:
      return options.regularisation_length.value_or(
          default_regularisation_length(problem.impulses.law()));
    case Equation::kf:
      return largest_jump_spacing(problem);
  }
  return 0;
}

Excitation excitation(const problem::ImpulseTrain& impulses, Equation equation, double step,
                      int lattice_cells) {
  switch (equation) {
    case Equation::white:
      return white_noise(impulses);
    case Equation::km4:
      return kramers_moyal(impulses, step, lattice_cells);
    case Equation::kf:
      return jumps(impulses, step, lattice_cells);
  }
  return {};
}

int cells_over(double length, double step) {
  return std::max(16, static_cast<int>(std::ceil(length / step - 1e-9)));
}

}  // namespace

Box initial_box(const problem::Problem& problem, const Options& options) {
  const auto linear = problem::equivalent_linearisation(problem);
  return {options.x1_max.value_or(kX1Box * linear.displacement_deviation),
          options.x2_max.value_or(kX2Box * linear.velocity_deviation)};
}

Discretisation discretise(const problem::Problem& problem, const Options& options, const Box& box) {
  const auto linear = problem::equivalent_linearisation(problem);
  double step = options.nv ? 2 * box.x2_max / *options.nv : kX2Step * linear.velocity_deviation;
  const double length = lattice_length(problem, options);
  int lattice_cells = 1;
  if (length > 0) {
    // A given number of cells must cover at least the box; a free one may round either way.
    const double wanted = options.nv ? std::floor(length / step + 1e-9) : std::round(length / step);
    lattice_cells = std::max(1, static_cast<int>(wanted));
    step = length / lattice_cells;
  }
  const int nv = options.nv.value_or(2 * cells_over(box.x2_max, step));
  if (length == 0) step = 2 * box.x2_max / nv;
  const int nx =
      options.nx.value_or(cells_over(box.x1_max, kX1Step * linear.displacement_deviation));
  const double spacing = lattice_cells * step;
  return {.grid = {nx, nv, box.x1_max, step * nv / 2},
          .excitation = excitation(problem.impulses, options.equation, step, lattice_cells),
          .regularisation_length = options.equation == Equation::km4 ? spacing : 0,
          .jump_spacing = options.equation == Equation::kf ? spacing : 0};
}

}  // namespace fpkcheck::fd_fpk
