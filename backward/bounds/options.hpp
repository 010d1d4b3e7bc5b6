#pragma once

#include <optional>
#include <vector>

#include "backward/bounds/bounded_expectation.hpp"
#include "base/options/option_description.hpp"

namespace fpkcheck::backward {

/// Options of compute_guaranteed_bounds().
struct BoundsOptions {
  /// Functionals of the density to bound; the command line has the option `--bin` instead
  std::vector<StationaryFunctional> functionals = default_functionals();
  /// Requested half-widths of the guaranteed intervals, absolute and relative to the magnitude of
  /// the functional. The spline grid is refined until the half-width of each bound is at most the
  /// maximum of `absolute_half_width` and `relative_half_width` times the magnitude of the
  /// functional. If both requested half-widths are 0, only the time limit ends the refinement.
  double absolute_half_width = 0;
  double relative_half_width = 0;
  /// Time limit in seconds (wall clock). A spline grid, except the first, is omitted if its
  /// computation would probably end after the time limit.
  double time_limit_seconds = 10;
  /// Number of threads, which does not change the computed bounds; default: one per processor
  std::optional<int> threads{};
};

/// Returns names, help texts and ranges of the options of the command `fpkcheck bounds`.
const base::OptionsDescription<BoundsOptions>& bounds_option_descriptions();

/// @throws InputError for the first invalid option, or for the first invalid functional
void require_valid_bounds_options(const BoundsOptions& options);

}  // namespace fpkcheck::backward
