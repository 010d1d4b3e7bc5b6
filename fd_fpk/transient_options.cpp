#include "fd_fpk/transient_options.hpp"

#include <fmt/format.h>

#include "base/input_error.hpp"

namespace fpkcheck::fd_fpk {
namespace {

using namespace base;

constexpr int kMostSnapshots = 10000;
constexpr int kHighestBdfOrder = 5;

// Upwind-biased operators of orders 3 and 5 have no eigenvalue with a positive real part. Centred
// operators, and operators of order 7 with their one-sided stencils at the walls, have such
// eigenvalues. Long implicit steps to stationarity damp these modes; accurate time steps amplify
// them.
void require_stable_order(int order) {
  if (order != 3 && order != 5) {
    throw InputError(fmt::format(
        "order {} of a density over time: the operator has growing modes; use order 3 or 5",
        order));
  }
}

Description<TransientOptions> make_transient_description() {
  using T = TransientOptions;
  const T defaults;
  return Description<T>("fd ")
      .add("until", &T::until,
           {"T",
            "density over time, 0 .. T, from an initial Gaussian, instead of the stationary "
            "density"},
           positive_numbers())
      .add("snapshots", &T::snapshots,
           {"N",
            fmt::format("with --until: number of intervals between stored densities (default {})",
                        defaults.snapshots)},
           closed_interval(1, kMostSnapshots))
      .add("start_y", &T::start_displacement,
           {"S",
            "with --until: standard deviation of y at t = 0 (default: about half of the stationary "
            "deviation)"},
           positive_numbers())
      .add(
          "start_v", &T::start_velocity,
          {"S",
           "with --until: standard deviation of y' at t = 0 (default: about half of the stationary "
           "deviation)"},
          positive_numbers())
      .add(
          "start_mean_y", &T::start_mean_displacement,
          {"M",
           "with --until: mean of y at t = 0, before truncation at the walls (default: about E[y]; "
           "the position of the wall, if there is only one wall, at the equilibrium)"},
          finite_numbers())
      .add("start_mean_v", &T::start_mean_velocity,
           {"M", "with --until: mean of y' at t = 0 (default: 0)"}, finite_numbers())
      .add("relative_tolerance", &T::relative_tolerance,
           {"R", fmt::format("with --until: local error of a time step relative to the largest "
                             "density (default {:g})",
                             defaults.relative_tolerance)},
           open_interval(0, 1))
      .with_flag("time-tolerance")
      .add("max_order", &T::max_order, {"N", "highest order of BDF"},
           closed_interval(1, kHighestBdfOrder))
      .without_flag();
}

}  // namespace

const Description<TransientOptions>& transient_option_descriptions() {
  // The description is constructed in a function of its own, because Clang 14 would destroy
  // temporaries of this initialiser at every call.
  static const auto description = make_transient_description();
  return description;
}

void validate(const Options& options, const TransientOptions& transient) {
  validate(options);
  require_stable_order(transport_order(options));
  if (options.tolerance || options.transport == TransportScheme::characteristics) {
    throw InputError(
        "tolerance or transport characteristics with a density over time: both apply to stationary "
        "densities; leave them out");
  }
  transient_option_descriptions().validate(transient);
}

}  // namespace fpkcheck::fd_fpk
