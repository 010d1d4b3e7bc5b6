#include "backward/bounds/options.hpp"

namespace fpkcheck::backward {

using namespace base;

const Description<Options>& description() {
  static const auto options =
      Description<Options>("bounds ")
          .add("width", &Options::relative_half_width,
               {"W", "refine the grid until every half-width is below W times the value"},
               non_negative_numbers())
          .add("absolute_width", &Options::half_width,
               {"W", "refine the grid until every half-width is below W"}, non_negative_numbers())
          .add("seconds", &Options::seconds,
               {"S", "time limit: start no grid that would end after the limit, except the first"},
               non_negative_numbers())
          .add("threads", &Options::threads, {"N", "threads to use (default: one per processor)"},
               closed_interval(1, 4096));
  return options;
}

void validate(const Options& options) {
  for (const Functional& functional : options.functionals) validate(functional);
  description().validate(options);
}

}  // namespace fpkcheck::backward
