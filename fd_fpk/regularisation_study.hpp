#pragma once

#include <complex>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fd_fpk/line/growth.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::fd_fpk {

/// One way to close the series after the fourth derivative, on one velocity step.
struct RegularisationRow {
  std::string scheme;  ///< "literal", "regularised", "0.9 l*", "1.1 l*", "pade"
  double step;         ///< h, width of the velocity cells
  double length;       ///< l, step of the fourth difference; 0 for pade, which has none
  int nx = 0;          ///< cells
  int nv = 0;
  std::optional<Growth> symbol = {};  ///< of the excitation, for waves in x2 alone
  /// Eigenvalue of the whole discrete operator with the largest real part, per unit time: 0, that
  /// of the stationary density, when nothing grows.
  std::optional<std::complex<double>> rightmost = {};
  /// The next one, when nothing grows: the slowest decay.
  std::optional<std::complex<double>> next = {};
  /// Of the null vector of the operator, whatever it is worth, on the same grid as `kf`:
  std::optional<double> l1_y = {};         ///< int |p(y) - p(y) of kf| dy
  std::optional<double> l1_ydot = {};      ///< the same of p(y')
  std::optional<double> min_density = {};  ///< smallest average over the largest |average|
  std::string remark = {};                 ///< why something is missing

  /// The rate at which what is not in the null vector grows: of the matrix where it is known, else
  /// of the symbol. Empty when nothing grows or nothing is known.
  std::optional<double> growth(const problem::Problem& problem) const;
};

struct RegularisationStudy {
  double default_length;   ///< l^2 = E[Y^6] / (5 E[Y^4])
  double shortest_length;  ///< l*: below it the symbol grows
  std::vector<RegularisationRow> rows;
};

struct RegularisationStudyOptions {
  /// The velocity steps: the default length divided by these.
  std::vector<int> divisions{1, 2, 4, 8};
  /// Cells in y. Growth is a matter of the waves in y'.
  int nx = 16;
};

/// What the literal and the regularised fourth difference of km4, and its Pade approximant, do on
/// finer and finer velocity steps: growth rates, eigenvalues and null vectors, well-posed or not.
/// Steps are not refused: fd_fpk::solve does that.
/// @throws InputError beyond the paper's class (problem::Features::original)
/// @param progress called before each row with its number and the number of all
RegularisationStudy study_regularisation(
    const problem::Problem& problem, const RegularisationStudyOptions& options = {},
    const std::function<void(int row, int rows)>& progress = {});

}  // namespace fpkcheck::fd_fpk
