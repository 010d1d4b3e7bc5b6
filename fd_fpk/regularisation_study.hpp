#pragma once

#include <complex>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fd_fpk/axis/growth_rate.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::fd_fpk {

/// One closure of the Kramers-Moyal series after the fourth derivative, for one velocity step.
struct RegularisationRow {
  std::string scheme;  ///< "literal", "regularised", "0.9 l*", "1.1 l*", "pade"
  double step;         ///< h, width of the velocity cells
  double length;       ///< l, step of the fourth difference; 0 for pade
  int nx = 0;          ///< number of cells in y and y'
  int nv = 0;
  std::optional<Growth> symbol = {};  ///< symbol of the excitation, for waves in x2 alone
  /// Rightmost eigenvalue of the whole discrete operator, per unit time. It is 0, the eigenvalue of
  /// the stationary density, when no mode is unstable.
  std::optional<std::complex<double>> rightmost = {};
  /// The second rightmost eigenvalue (the slowest decay rate), when no mode is unstable.
  std::optional<std::complex<double>> next = {};
  /// For the null vector of the operator (a density or not), on the same grid as `kf`:
  std::optional<double> l1_y = {};     ///< int |p(y) - p(y) of kf| dy
  std::optional<double> l1_ydot = {};  ///< the same for p(y')
  /// Smallest cell average relative to the largest |average|.
  std::optional<double> min_density = {};
  std::string remark = {};  ///< why a value above is missing

  /// The growth rate of modes outside the null vector: from the matrix where its eigenvalue is
  /// known, else from the symbol. Empty when no mode is unstable or no rate is known.
  std::optional<double> growth(const problem::Problem& problem) const;
};

struct RegularisationStudy {
  double default_length;   ///< l^2 = E[Y^6] / (5 E[Y^4])
  double shortest_length;  ///< l*: for a shorter l the symbol has a positive real part
  std::vector<RegularisationRow> rows;
};

struct RegularisationStudyOptions {
  /// Each velocity step is the default length divided by one of these.
  std::vector<int> divisions{1, 2, 4, 8};
  /// Cells in y. Few suffice, since the growth rate depends on the waves in y' alone.
  int nx = 16;
};

/// Study of the literal and the regularised fourth difference of km4, and of its Pade approximant,
/// for decreasing velocity steps: growth rates, eigenvalues and null vectors, for well-posed and
/// ill-posed schemes alike. Ill-posed steps are included here; fd_fpk::solve refuses them.
/// @throws InputError outside the paper's class (problem::is_paper_oscillator)
/// @param progress called before each row with its number and the total number of rows
RegularisationStudy study_regularisation(
    const problem::Problem& problem, const RegularisationStudyOptions& options = {},
    const std::function<void(int row, int rows)>& progress = {});

}  // namespace fpkcheck::fd_fpk
