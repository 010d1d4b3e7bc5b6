#include "epc/gaussian_search.hpp"

#include <fmt/format.h>

#include "epc/continuation.hpp"

namespace fpkcheck::epc {
namespace {

// Q_2 of the Gaussian with the deviations of the weights.
std::vector<Term> linearised(const Deviations& sigma) {
  return {{2, 0, -1 / (2 * sigma.x1 * sigma.x1)}, {0, 2, -1 / (2 * sigma.x2 * sigma.x2)}};
}

}  // namespace

Search find_root(const Projection& projection, const ResidualCoefficients& f,
                 const Options& options) {
  const Eigen::VectorXd start = projection.basis().scaled(linearised(projection.basis().sigma()));
  Search search{newton(projection, f, start,
                       {.tolerance = options.tolerance, .max_iterations = options.max_iterations}),
                ""};
  if (search.root.converged) return search;
  const int plain_iterations = search.root.iterations;
  const Branch branch = follow_branch(projection, f, options.tolerance);
  search.root.iterations += branch.iterations;
  if (branch.reached == 1) {
    search.root.a = branch.a;
    search.root.residual = branch.residual;
    search.root.converged = true;
    return search;
  }
  search.failure = fmt::format(
      "plain Newton steps from equivalent linearisation found no root in {} iterations (least "
      "residual {:.1e}, asked for {:.1e}), and the branch of solutions that starts from white "
      "noise at an impact without loss ends at {:.0f} % of the way to the full problem",
      plain_iterations, search.root.residual, options.tolerance, 100 * branch.reached);
  return search;
}

}  // namespace fpkcheck::epc
