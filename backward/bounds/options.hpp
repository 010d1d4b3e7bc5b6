#pragma once

#include <optional>
#include <vector>

#include "backward/bounds/functional.hpp"
#include "base/options/description.hpp"

namespace fpkcheck::backward {

/// What to bound, and how narrowly.
struct Options {
  std::vector<Functional> functionals = standard_functionals();  ///< no part of the description
  /// Grids are refined until every half-width is below `half_width` or below `relative_half_width`
  /// of the value, whichever is larger; with both 0 until the time is used up.
  double half_width = 0;
  double relative_half_width = 0;
  /// No grid is begun that is likely to end later than this many seconds (wall clock). The first
  /// one always is.
  double seconds = 10;
  std::optional<int> threads{};  ///< automatic: one per processor; bounds do not depend on it
};

/// The options as the command line names them.
const base::Description<Options>& description();

/// @throws InputError on the first option that cannot be used
void validate(const Options& options);

}  // namespace fpkcheck::backward
