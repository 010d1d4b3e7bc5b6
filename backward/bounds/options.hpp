#pragma once

#include <optional>
#include <vector>

#include "backward/bounds/functional.hpp"
#include "base/options/description.hpp"

namespace fpkcheck::backward {

/// Options of the bounds: functionals, requested widths, time limit and number of threads.
struct Options {
  std::vector<Functional> functionals = default_functionals();  ///< not a command-line option
  /// Requested half-widths of the bounds. Grids are refined until every half-width is below the
  /// larger of `half_width` and `relative_half_width` times the value. If both are 0, only the time
  /// limit ends the refinement.
  double half_width = 0;
  double relative_half_width = 0;
  /// Time limit in seconds (wall clock). No grid is started whose computation would probably end
  /// after the limit, except the first grid.
  double seconds = 10;
  /// Number of threads. Default: one per processor. The bounds are independent of this number.
  std::optional<int> threads{};
};

/// Description of the options with their names on the command line.
const base::Description<Options>& description();

/// @throws InputError on the first invalid option
void validate(const Options& options);

}  // namespace fpkcheck::backward
