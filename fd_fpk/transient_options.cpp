#include "fd_fpk/transient_options.hpp"

#include <fmt/format.h>

#include "base/input_error.hpp"

namespace fpkcheck::fd_fpk {
namespace {

using namespace base;

constexpr int kMostSnapshots = 10000;
constexpr int kHighestBdfOrder = 5;

// Upwind-biased operators of order 3 and 5 have no eigenvalue to the right of the imaginary axis.
// Centred ones, and the one-sided stencils of order 7 at the walls, do: a march to stationarity
// with long implicit steps does not see them, accurate steps in time follow them.
void require_stable_order(int order) {
  if (order != 3 && order != 5) {
    throw InputError(fmt::format(
        "finite-difference order {} over time (it has growing modes: use 3 or 5)", order));
  }
}

Description<TransientOptions> make_transient_description() {
  using T = TransientOptions;
  const T defaults;
  return Description<T>("fd ")
      .add("until", &T::until,
           {"T",
            "the density over time, 0 .. T, from a Gaussian start, instead of the stationary "
            "one"},
           positive())
      .add("snapshots", &T::snapshots,
           {"N", fmt::format("with --until: T/N apart (default {})", defaults.snapshots)},
           between(1, kMostSnapshots))
      .add(
          "start_y", &T::start_displacement,
          {"S",
           "with --until: deviation of y in the Gaussian start (default: about half the stationary "
           "one)"},
          positive())
      .add("start_v", &T::start_velocity,
           {"S", "with --until: deviation of y' in the start (default: likewise)"}, positive())
      .add("start_mean_y", &T::start_mean_displacement,
           {"M",
            "with --until: middle of the start, of which walls cut off what is beyond (default: "
            "about E[y]; the wall, where there is one at the equilibrium alone)"},
           any_number())
      .add("start_mean_v", &T::start_mean_velocity,
           {"M", "with --until: its velocity (default: 0)"}, any_number())
      .add("relative_tolerance", &T::relative_tolerance,
           {"R", fmt::format("with --until: local error of a time step relative to the largest "
                             "density (default {:g})",
                             defaults.relative_tolerance)},
           strictly_between(0, 1))
      .with_flag("time-tolerance")
      .add("max_order", &T::max_order, {"N", "highest order of BDF"}, between(1, kHighestBdfOrder))
      .without_flag();
}

}  // namespace

const Description<TransientOptions>& transient_description() {
  // Made elsewhere: where the making stands here, Clang 14 destroys parts of it at every call.
  static const auto description = make_transient_description();
  return description;
}

void validate(const Options& options, const TransientOptions& transient) {
  validate(options);
  require_stable_order(order_of(options));
  if (options.tolerance || options.transport == Transport::characteristics) {
    throw InputError(
        "tolerance or transport characteristics over time (they are for the stationary density: "
        "leave them out)");
  }
  transient_description().validate(transient);
}

}  // namespace fpkcheck::fd_fpk
