#include "problem/noise.hpp"

namespace fpkcheck::problem {

using namespace base;

const Description<Noise>& noise_parameter_description() {
  static const auto description =
      Description<Noise>("noise.")
          .add("intensity", &Noise::intensity, {"I", "intensity of the Gaussian white noise"},
               non_negative_numbers())
          .with_symbol("2D", "2D")
          .with_default(0.0);
  return description;
}

}  // namespace fpkcheck::problem
