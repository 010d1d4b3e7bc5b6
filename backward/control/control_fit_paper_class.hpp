#pragma once

#include "backward/control/control_functions.hpp"
#include "numerics/splines/quintic_bsplines.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::backward {

/// Numbers of cells of the splines of y and of y'.
struct ControlCells {
  int y, v;
};

/// The splines of the control functions.
struct ControlSplines {
  numerics::QuinticBSplines y, v;
};

/// Splines of the control functions for the paper's class, determined by the standard deviations of
/// equivalent linearisation. The ends are 9 deviations from the static deflection in y and 10.5
/// deviations to both sides in v. The cells are uniform up to 5 deviations in y and 6 in v. The
/// knot at v = 0 is triple, since grazing impacts cause a corner of h there.
/// @param graded_cells number of cells that become narrower towards the wall and towards v = 0
/// (graded_knots)
ControlSplines control_splines_paper_class(const problem::Problem& problem,
                                           const ControlCells& cells, int graded_cells = 0);

/// The fit of the control functions on splines of y and v, with the weight
///
///     w(y, v) = exp(-(U(y) - lambda E[Y] y) / T) exp(-v^2 / 2T),   T = 2 variances of y',
///
/// normalised to 1 at its maximum; each factor is at least 1e-9. The term with E[Y] is present only
/// for E[Y] > 0, a mean force directed off the wall.
/// @param problem, y, v must outlive the returned fit, which refers to them
ControlFitProblem control_fit_paper_class(const problem::Problem& problem,
                                          const numerics::QuinticBSplines& y,
                                          const numerics::QuinticBSplines& v, double wall_weight);

}  // namespace fpkcheck::backward
