#include "problem/laws/gaussian.hpp"

#include <boost/math/distributions/normal.hpp>
#include <boost/math/special_functions/factorials.hpp>

namespace fpkcheck::problem {

double GaussianLaw::standardised_moment(int n) const {
  if (n % 2 != 0) return 0;
  return n == 0 ? 1 : boost::math::double_factorial<double>(static_cast<unsigned>(n - 1));
}

double GaussianLaw::density(double y) const {
  return boost::math::pdf(boost::math::normal(mean, deviation), y);
}

double GaussianLaw::cumulative_probability(double y) const {
  return boost::math::cdf(boost::math::normal(mean, deviation), y);
}

}  // namespace fpkcheck::problem
