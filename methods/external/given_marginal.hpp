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

/// What a file held, and what was made of it.
struct GivenFile {
  std::string path;
  std::string form;  ///< "histogram" or "points"
  std::size_t rows = 0;
  std::string values = {};             ///< of a histogram: "density", "probability", "count"
  double from = 0, to = 0;             ///< range of the abscissa
  double integral = 0;                 ///< as it stands in the file
  std::optional<double> divided_by{};  ///< to have mass 1
  std::vector<std::string> notes{};    ///< for people
};

/// A marginal density that others computed or measured, from a file.
///
/// Two columns are abscissa and density; three are those of a histogram (is_histogram), else
/// abscissa, density and standard error. Between points the density is Akima's modified
/// interpolant; within the bins of a histogram it is the slope of the cumulative's monotone cubic.
/// From a first or last point of y that is no farther from the wall than from its neighbour, it is
/// continued to the wall by a straight line. Elsewhere outside the file's range it is 0.
class GivenMarginal {
 public:
  /// @param table of the columns above
  /// @param walls between which y lies
  /// @throws InputError SOURCE:LINE: what is wrong and what is allowed
  GivenMarginal(const NumberTable& table, const problem::Walls& walls);

  transform::Variable variable() const { return variable_; }

  /// Averages over bins, with 95 % intervals where the file has standard errors.
  transform::Marginal on(std::span<const double> edges) const;

  /// The integral of x^power over the file's range.
  double moment(int power) const;

  /// The share of its mass that lies outside lower <= x <= upper.
  double share_beyond(double lower, double upper) const;

  /// The L1 distance from the truth over bins that the file's standard errors let one expect.
  /// Where has_errors().
  BinSamplingL1 sampling_l1(std::span<const double> edges) const;
  bool has_errors() const { return !errors_.empty(); }

  /// What was read, and what was made of it.
  const GivenFile& file() const { return file_; }

 private:
  void read_histogram(const NumberTable& table);
  void read_points(const NumberTable& table);
  void normalise(BinValue value);
  void note_cut_ends();
  double cumulative(double x) const;

  transform::Variable variable_;
  problem::Walls walls_;            // of y
  Reached continued_;               // to which of them
  std::vector<double> knots_;       // edges or points
  std::vector<double> cumulative_;  // at the knots
  std::function<double(double)> density_;
  double scale_ = 1;            // of density_, to have mass 1
  std::vector<double> errors_;  // standard errors of the file's points, or empty
  GivenFile file_;
};

}  // namespace fpkcheck::methods
