#pragma once

#include <optional>
#include <vector>

#include "backward/bounds/functional.hpp"
#include "base/options/description.hpp"

namespace fpkcheck::backward {

/// Functionals, requested widths and limits of the computation.
struct Options {
  std::vector<Functional> functionals = standard_functionals();  ///< not in the description
  /// Grids are refined until every half-width is below `half_width` or `relative_half_width` times
  /// the value, whichever is larger. With both 0 only the time limit ends the refinement.
  double half_width = 0;
  double relative_half_width = 0;
  /// Time limit in seconds (wall clock): no grid is started that would end later, except the first.
  double seconds = 10;
  std::optional<int> threads{};  ///< default: one per processor; bounds do not depend on it
};

/// The options with their names on the command line.
const base::Description<Options>& description();

/// @throws InputError on the first invalid option
void validate(const Options& options);

}  // namespace fpkcheck::backward
