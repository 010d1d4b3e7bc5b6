#pragma once

#include <complex>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fd_fpk/axis/excitation.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::fd_fpk {

/// Results of one scheme for the Kramers-Moyal series truncated after the fourth derivative, for
/// one width of the velocity cells.
struct RegularisationRow {
  std::string scheme;  ///< "literal", "regularised", "0.9 l*", "1.1 l*", "pade"
  double step;         ///< width h of the velocity cells
  double length;       ///< step l of the fourth difference; 0 for pade
  int nx = 0;          ///< number of cells in y and y'
  int nv = 0;
  /// growth rate computed from the symbol of the excitation, for waves that depend on x2 alone
  std::optional<FastestGrowingWave> symbol = {};
  /// Rightmost eigenvalue of the whole discrete operator, per unit time. If no mode is unstable,
  /// the rightmost eigenvalue is 0 and belongs to the stationary density.
  std::optional<std::complex<double>> rightmost = {};
  /// The second eigenvalue from the right (the slowest decay rate), if no mode is unstable.
  std::optional<std::complex<double>> next = {};
  /// The values l1_y, l1_ydot and min_density describe the null vector p of the operator, on the
  /// grid on which the density of `kf` is computed. The null vector need not be a density.
  std::optional<double> l1_y = {};     ///< int |p(y) - p(y) of kf| dy
  std::optional<double> l1_ydot = {};  ///< int |p(y') - p(y') of kf| dy'
  /// Smallest cell average relative to the largest |average|.
  std::optional<double> min_density = {};
  std::string remark = {};  ///< reason why a value above is missing

  /// The growth rate of the fastest growing mode other than the null vector: the rightmost
  /// eigenvalue of the operator if known, else the maximum of the symbol. The growth rate is empty
  /// if no mode is unstable or no rate is known.
  std::optional<double> growth_rate(const problem::Problem& problem) const;
};

struct RegularisationStudy {
  double default_length;  ///< l^2 = E[Y^6] / (5 E[Y^4])
  /// the length l*: for every shorter l the symbol has a positive real part
  double shortest_length;
  std::vector<RegularisationRow> rows;
};

struct RegularisationStudyOptions {
  /// Divisors: each velocity step of the study is the default regularisation length divided by one
  /// of these numbers.
  std::vector<int> divisions{1, 2, 4, 8};
  /// Number of cells in y. A small number suffices, since the growth rate depends on the waves in
  /// y' alone.
  int nx = 16;
};

/// Study of the literal and the regularised fourth difference of km4, and of its Pade approximant,
/// for decreasing velocity steps: growth rates, eigenvalues and null vectors, for well-posed and
/// ill-posed schemes alike. The study includes ill-posed velocity steps, which fd_fpk::solve
/// refuses.
/// @throws InputError unless problem::has_equivalent_linearisation(problem)
/// @param progress function that is called before each row is computed, with the number of the row
/// and the total number of rows
RegularisationStudy study_regularisation(
    const problem::Problem& problem, const RegularisationStudyOptions& options = {},
    const std::function<void(int row, int rows)>& progress = {});

}  // namespace fpkcheck::fd_fpk
