#include "problem/laws/laplace.hpp"

#include <boost/math/distributions/laplace.hpp>
#include <boost/math/special_functions/factorials.hpp>
#include <cmath>

namespace fpkcheck::problem {

double LaplaceLaw::standardised_moment(int n) const {
  if (n % 2 != 0) return 0;
  return boost::math::factorial<double>(static_cast<unsigned>(n)) / std::pow(2.0, n / 2);
}

double LaplaceLaw::density(double y) const {
  return boost::math::pdf(boost::math::laplace(mean, scale), y);
}

double LaplaceLaw::cumulative_probability(double y) const {
  return boost::math::cdf(boost::math::laplace(mean, scale), y);
}

}  // namespace fpkcheck::problem
