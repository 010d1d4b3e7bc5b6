#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "methods/external/between_walls.hpp"
#include "methods/external/bin_average_errors.hpp"
#include "methods/external/column_meaning.hpp"
#include "methods/external/number_table.hpp"
#include "transform/marginal.hpp"

namespace fpkcheck::methods {

/// Properties of a file with a marginal density, and of its normalisation, for the summary of a
/// run.
struct MarginalFileSummary {
  std::string path;         ///< name of the file
  std::string form;         ///< "histogram" or "points"
  std::size_t rows = 0;     ///< number of rows
  std::string values = {};  ///< quantity of a histogram: "density", "probability", "count"
  double from = 0, to = 0;  ///< range of the abscissa
  double integral = 0;      ///< integral of the density before normalisation
  std::optional<double> divided_by{};  ///< divisor of the normalisation to mass 1, if normalised
  std::vector<std::string> notes{};    ///< remarks for the user
};

/// An external marginal density from a file.
///
/// A file with two columns contains abscissa and density. A file with three columns contains a
/// histogram (is_histogram), or else abscissa, density and standard error. Between points the
/// density is Akima's modified interpolant. Within the bins of a histogram the density is the
/// derivative of a monotone cubic interpolant of the cumulative distribution. If the first or last
/// point of y is not farther from a wall than from its neighbour, the density is extrapolated
/// linearly to the wall. Elsewhere outside the range of the file the density is 0.
class ExternalMarginal {
 public:
  /// @param table columns of the file, as above
  /// @param walls walls that limit y
  /// @throws InputError with a message "SOURCE:LINE: problem (admissible values)"
  ExternalMarginal(const NumberTable& table, const problem::Walls& walls);

  transform::Variable variable() const { return variable_; }

  /// The averages of the density over bins, with 95 % confidence intervals if the file has standard
  /// errors.
  transform::Marginal average_over_bins(std::span<const double> edges) const;

  /// The moment E[x^power] of the variable x: the integral of x^power times the density over the
  /// range of the file.
  double moment(int power) const;

  /// The fraction of the mass outside the interval lower <= x <= upper.
  double mass_fraction_outside(double lower, double upper) const;

  /// The L1 sampling error of the averages over bins, from the standard errors in the file.
  /// @pre has_standard_errors()
  L1SamplingError l1_sampling_error(std::span<const double> edges) const;
  /// Whether the file has standard errors.
  bool has_standard_errors() const { return !errors_.empty(); }

  /// The properties of the file and of its normalisation.
  const MarginalFileSummary& file() const { return file_; }

 private:
  void read_histogram(const NumberTable& table);
  void read_points(const NumberTable& table);
  void normalise(HistogramQuantity value);
  void add_cut_off_notes();
  double cumulative(double x) const;

  transform::Variable variable_;
  problem::Walls walls_;             // walls that limit y; no walls for a density of y'
  WallExtrapolation extrapolation_;  // walls to which the density is extrapolated
  std::vector<double> knots_;        // edges of bins, or points and walls
  std::vector<double> cumulative_;   // cumulative distribution at the knots
  std::function<double(double)> density_;
  double scale_ = 1;            // factor of density_ for mass 1
  std::vector<double> errors_;  // standard errors of the file's points, or empty
  MarginalFileSummary file_;
};

}  // namespace fpkcheck::methods
