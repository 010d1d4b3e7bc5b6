#include "fd_fpk/discretisation.hpp"

#include <fmt/format.h>

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

// As a double: a box may ask for more cells than an int can count.
double cells_over(double length, double step) {
  return std::max(16.0, std::ceil(length / step - 1e-9));
}

// Why a grid cannot be made or would not do; empty when it can.
std::string objection(const Options& options, const Box& box, double nx, double nv, double length,
                      double step) {
  if (length > box.x2_max / 2) {
    return fmt::format(
        "the lattice of {} has step {:.3g} in a box |y'| <= {:.3g} (take a shorter "
        "regularisation length or a wider box)",
        name(options.equation), length, box.x2_max);
  }
  if (step * nv / 2 < box.x2_max * (1 - 1e-9)) {
    return fmt::format(
        "{:.0f} cells in y' do not reach |y'| = {:.3g}: the lattice of {} allows steps of at "
        "most {:.3g} (give nv = {:.0f} or more, or leave it out)",
        nv, box.x2_max, name(options.equation), length, 2 * std::ceil(box.x2_max / length));
  }
  if (nx * nv > kMostCells) {
    return fmt::format(
        "the grid needs {:.0f} x {:.0f} cells, more than {} (the impulses or the cells asked for "
        "are small against the box: solve white or km4, or give nx, nv or a smaller box)",
        nx, nv, kMostCells);
  }
  return "";
}

}  // namespace

Box initial_box(const problem::Problem& problem, const Options& options) {
  const auto linear = problem::equivalent_linearisation(problem);
  return {options.x1_max.value_or(problem::static_deflection(problem) +
                                  kX1Box * linear.displacement_deviation),
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
  const double nv = options.nv ? *options.nv : 2 * cells_over(box.x2_max, step);
  if (length == 0) step = 2 * box.x2_max / nv;
  const double nx =
      options.nx ? *options.nx : cells_over(box.x1_max, kX1Step * linear.displacement_deviation);
  const std::string refusal = objection(options, box, nx, nv, length, step);
  if (!refusal.empty())
    return {.grid = {0, 0, box.x1_max, box.x2_max}, .excitation = {}, .refusal = refusal};
  const double spacing = lattice_cells * step;
  return {.grid = {static_cast<int>(nx), static_cast<int>(nv), box.x1_max, step * nv / 2},
          .excitation = excitation(problem.impulses, options.equation, step, lattice_cells),
          .regularisation_length = options.equation == Equation::km4 ? spacing : 0,
          .jump_spacing = options.equation == Equation::kf ? spacing : 0};
}

}  // namespace fpkcheck::fd_fpk
