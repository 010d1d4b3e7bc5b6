#pragma once

#include <optional>
#include <vector>

#include "backward/bounds/functional.hpp"
#include "base/options/description.hpp"

namespace fpkcheck::backward {

struct Options {
  /// The functionals are not a command-line option
  std::vector<Functional> functionals = default_functionals();
  /// Requested half-widths of the bounds. Grids are refined until every half-width is below the
  /// maximum of `half_width` and `relative_half_width` times the value. If `half_width` and
  /// `relative_half_width` are 0, only the time limit ends the refinement.
  double half_width = 0;
  double relative_half_width = 0;
  /// Time limit in seconds (wall clock). A grid, except the first, is omitted if its computation
  /// would probably end after the limit.
  double seconds = 10;
  /// Number of threads, which does not change the bounds; default: one per processor
  std::optional<int> threads{};
};

const base::Description<Options>& description();

/// @throws InputError for the first invalid option
void validate(const Options& options);

}  // namespace fpkcheck::backward
