#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "methods/external/bin_average_errors.hpp"
#include "methods/external/number_table.hpp"
#include "methods/external/range_between_walls.hpp"
#include "transform/marginal_density.hpp"

namespace fpkcheck::methods {

/// Properties of a marginal density file and of its normalisation, for the summary of a run.
struct MarginalFileSummary {
  std::string path;
  std::string form;  ///< form of the data: "histogram" or "points"
  std::size_t rows = 0;
  std::string values = {};  ///< quantity of a histogram: "density", "probability" or "count"
  double from = 0, to = 0;  ///< range of the abscissae in the file
  double integral = 0;      ///< integral of the density before normalisation
  std::optional<double> divided_by{};  ///< divisor that normalises the mass to 1
  std::vector<std::string> notes{};
};

/// An external marginal density from a file.
///
/// A marginal density file with two columns contains abscissae and densities. A marginal density
/// file with three columns contains a histogram (is_histogram), or abscissae, densities and
/// standard errors. Akima's modified interpolation gives the marginal density between the points of
/// the file. Within the bins of a histogram, the density is the derivative of a monotone cubic
/// interpolant of the cumulative distribution. A marginal density of y is extrapolated linearly to
/// a wall near the first or last point (WallExtrapolation). At all other points outside the range
/// of the file the marginal density is 0.
class ExternalMarginal {
 public:
  /// @throws InputError with a message "SOURCE:LINE: problem (admissible values)"
  ExternalMarginal(const NumberTable& table, const problem::Walls& walls);

  transform::StateVariable variable() const { return variable_; }

  /// Returns the averages of the marginal density over bins, with 95 % confidence intervals if the
  /// file has standard errors.
  transform::Marginal average_over_bins(std::span<const double> edges) const;

  /// Returns the moment E[x^power] of the variable x (y or y') over the range of the file.
  double moment(int power) const;

  /// Returns the fraction of the mass of the density outside the interval lower <= x <= upper.
  double mass_fraction_outside(double lower, double upper) const;

  /// Returns the L1 sampling error of the bin averages, from the standard errors in the file.
  /// @pre has_standard_errors()
  L1SamplingError l1_sampling_error(std::span<const double> edges) const;
  bool has_standard_errors() const { return !errors_.empty(); }

  const MarginalFileSummary& file() const { return file_; }

 private:
  void read_histogram(const NumberTable& table);
  void read_points(const NumberTable& table);
  void normalise(HistogramQuantity value);
  void add_cut_off_notes();
  double marginal_cumulative_probability(double x) const;

  transform::StateVariable variable_;
  problem::Walls walls_;  // walls; none for a density of y'
  WallExtrapolation extrapolation_;
  std::vector<double> knots_;       // bin edges, or points of the density and walls
  std::vector<double> cumulative_;  // cumulative distribution at the knots
  std::function<double(double)> density_;
  double scale_ = 1;            // factor that normalises density_ to mass 1
  std::vector<double> errors_;  // standard errors of the density in the file; may be empty
  MarginalFileSummary file_;
};

}  // namespace fpkcheck::methods
