#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "methods/external/between_walls.hpp"
#include "methods/external/bin_errors.hpp"
#include "methods/external/column_meaning.hpp"
#include "methods/external/number_table.hpp"
#include "transform/marginal.hpp"

namespace fpkcheck::methods {

/// The contents of a file and their treatment, for the summary of a run.
struct FileTreatment {
  std::string path;
  std::string form;  ///< "histogram" or "points"
  std::size_t rows = 0;
  std::string values = {};             ///< of a histogram: "density", "probability", "count"
  double from = 0, to = 0;             ///< range of the abscissa
  double integral = 0;                 ///< before normalisation
  std::optional<double> divided_by{};  ///< divisor of the normalisation to mass 1
  std::vector<std::string> notes{};    ///< remarks for the user
};

/// An external marginal density from a file.
///
/// Two columns are abscissa and density. Three columns are a histogram (is_histogram), or else
/// abscissa, density and standard error. Between points the density is Akima's modified
/// interpolant; within the bins of a histogram the density is the derivative of a monotone cubic
/// interpolant of the cumulative distribution. A first or last point of y that is no farther from
/// the wall than from its neighbour is extrapolated linearly to the wall. Elsewhere outside the
/// file's range the density is 0.
class ExternalMarginal {
 public:
  /// @param table with the columns above
  /// @param walls that limit y
  /// @throws InputError SOURCE:LINE: the problem and what is allowed
  ExternalMarginal(const NumberTable& table, const problem::Walls& walls);

  transform::Variable variable() const { return variable_; }

  /// Averages over bins, with 95 % intervals where the file has standard errors.
  transform::Marginal average_over(std::span<const double> edges) const;

  /// The integral of x^power over the file's range.
  double moment(int power) const;

  /// The fraction of the mass outside lower <= x <= upper.
  double fraction_outside(double lower, double upper) const;

  /// The sampling error in L1 over bins, by the file's standard errors.
  /// @pre has_errors()
  BinSamplingL1 sampling_l1(std::span<const double> edges) const;
  bool has_errors() const { return !errors_.empty(); }

  /// The contents of the file and their treatment.
  const FileTreatment& file() const { return file_; }

 private:
  void read_histogram(const NumberTable& table);
  void read_points(const NumberTable& table);
  void normalise(BinValue value);
  void add_cut_off_notes();
  double cumulative(double x) const;

  transform::Variable variable_;
  problem::Walls walls_;             // of y; none for y'
  WallExtrapolation extrapolation_;  // walls to which the density is extrapolated
  std::vector<double> knots_;        // edges of bins, or points and walls
  std::vector<double> cumulative_;   // at the knots
  std::function<double(double)> density_;
  double scale_ = 1;            // factor of density_ for mass 1
  std::vector<double> errors_;  // standard errors of the file's points, or empty
  FileTreatment file_;
};

}  // namespace fpkcheck::methods
