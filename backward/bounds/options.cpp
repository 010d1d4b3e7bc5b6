#include "backward/bounds/options.hpp"

namespace fpkcheck::backward {

using namespace base;

const OptionsDescription<BoundsOptions>& bounds_option_descriptions() {
  static const auto options =
      OptionsDescription<BoundsOptions>("bounds ")
          .add("width", &BoundsOptions::relative_half_width,
               {"W", "refine the grid until every half-width is below W times the value"},
               non_negative_numbers())
          .add("absolute_width", &BoundsOptions::absolute_half_width,
               {"W", "refine the grid until every half-width is below W"}, non_negative_numbers())
          .add("seconds", &BoundsOptions::time_limit_seconds,
               {"S", "time limit: start no grid that would end after the limit, except the first"},
               non_negative_numbers())
          .add("threads", &BoundsOptions::threads,
               {"N", "threads to use (default: one per processor)"}, closed_interval(1, 4096));
  return options;
}

void require_valid_bounds_options(const BoundsOptions& options) {
  for (const StationaryFunctional& functional : options.functionals)
    require_valid_functional(functional);
  bounds_option_descriptions().validate(options);
}

}  // namespace fpkcheck::backward
