#include "fd_fpk/operator/well_posedness.hpp"

#include <fmt/format.h>

namespace fpkcheck::fd_fpk {

Growth largest_growth(const problem::Problem& problem, const Options& options, double step) {
  const auto [line, excitation] = unbounded_excitation(problem, options, step);
  return largest_growth(line, excitation, centred_points(options.order));
}

Posedness posedness(const problem::Problem& problem, const Options& options,
                    const Discretisation& discretisation) {
  if (options.equation != Equation::km4 && options.equation != Equation::km4_pade) return {};
  const auto& impulses = problem.impulses;
  Posedness result{
      .growth = largest_growth(problem, options, discretisation.grid.x2.smallest_width()),
      .objection = {}};
  if (!grows(result.growth, impulses)) return result;
  result.objection = fmt::format(
      "the series cut after the fourth derivative grows at rate {:.3g} at wavenumber {:.3g} with "
      "the fourth difference over {:.3g} (use a regularisation length of at least {:.3g}; the "
      "default is {:.3g})",
      result.growth.rate, result.growth.wavenumber, discretisation.regularisation_length,
      shortest_regularisation_length(impulses.law()),
      default_regularisation_length(impulses.law()));
  return result;
}

}  // namespace fpkcheck::fd_fpk
