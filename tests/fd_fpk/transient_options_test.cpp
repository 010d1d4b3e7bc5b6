#include "fd_fpk/transient_options.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/input_error.hpp"

namespace fpkcheck::fd_fpk {
namespace {

TEST(TransientOptions, RoundTripThroughTheirValues) {
  const auto& description = transient_option_descriptions();
  const auto defaults = description.values({});
  const auto values = description.values({.until = 7,
                                          .snapshots = 11,
                                          .start_displacement = 0.3,
                                          .start_velocity = 0.4,
                                          .start_mean_displacement = -0.2,
                                          .start_mean_velocity = 0.1,
                                          .relative_tolerance = 1e-4,
                                          .max_order = 3});
  EXPECT_EQ(description.values(description.read(values, "options")), values);
  for (std::size_t k = 0; k < values.size(); ++k)
    EXPECT_NE(values[k], defaults[k]) << values[k].name;
}

TEST(TransientOptions, HaveTheFlagsOfTheCommandLine) {
  std::vector<std::string> flags;
  for (const auto& parameter : transient_option_descriptions().parameters())
    flags.push_back(parameter.flag);
  EXPECT_EQ(flags,
            (std::vector<std::string>{"until", "snapshots", "start-y", "start-v", "start-mean-y",
                                      "start-mean-v", "time-tolerance", ""}));
}

TEST(TransientOptions, InvalidValuesAreRefused) {
  const auto refused = [](const TransientOptions& transient, const Options& options = {}) {
    EXPECT_THROW(validate(options, transient), InputError);
  };
  EXPECT_NO_THROW(validate({}, {.until = 1}));
  refused({});
  refused({.until = -1});
  refused({.until = HUGE_VAL});
  refused({.until = 1, .snapshots = 0});
  refused({.until = 1, .start_displacement = 0.0});
  refused({.until = 1, .start_velocity = -1.0});
  refused({.until = 1, .start_mean_displacement = HUGE_VAL});
  refused({.until = 1, .relative_tolerance = 0});
  refused({.until = 1, .max_order = 6});
  refused({.until = 1}, {.tolerance = 1e-4});
  refused({.until = 1}, {.transport = TransportScheme::characteristics});
  refused({.until = 1}, {.refinement = -1});
  for (const int order : {2, 4, 6, 7, 8}) refused({.until = 1}, {.order = order});
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
