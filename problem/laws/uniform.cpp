#include "problem/laws/uniform.hpp"

#include <boost/math/distributions/uniform.hpp>
#include <boost/math/special_functions/sinc.hpp>
#include <boost/math/special_functions/sinhc.hpp>

namespace fpkcheck::problem {

double UniformLaw::density(double y) const {
  return boost::math::pdf(boost::math::uniform(mean - half_width, mean + half_width), y);
}

double UniformLaw::cumulative_probability(double y) const {
  return boost::math::cdf(boost::math::uniform(mean - half_width, mean + half_width), y);
}

std::complex<double> UniformLaw::centred_characteristic_function(double u) const {
  return boost::math::sinc_pi(u * half_width);
}

double UniformLaw::centred_moment_generating_function(double u) const {
  return boost::math::sinhc_pi(u * half_width);
}

}  // namespace fpkcheck::problem
