#include "backward/bounds/options.hpp"

namespace fpkcheck::backward {

using namespace base;

const Description<Options>& description() {
  static const auto options =
      Description<Options>("bounds ")
          .add("width", &Options::relative_half_width,
               {"W",
                "refine until every half-width is below W of the value, or the time is used up"},
               not_negative())
          .add("absolute_width", &Options::half_width, {"W", "the same, W itself"}, not_negative())
          .add("seconds", &Options::seconds,
               {"S", "begin no grid that is likely to end later (the first one always is)"},
               not_negative())
          .add("threads", &Options::threads, {"N", "threads to use (default: one per processor)"},
               between(1, 4096));
  return options;
}

void validate(const Options& options) {
  for (const Functional& functional : options.functionals) validate(functional);
  description().validate(options);
}

}  // namespace fpkcheck::backward
