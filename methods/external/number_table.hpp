#pragma once

#include <istream>
#include <string>
#include <string_view>
#include <vector>

#include "base/options/enum_names.hpp"
#include "methods/external/external_samples.hpp"
#include "transform/marginal_density.hpp"

namespace fpkcheck::methods {

/// Columns of numbers from an external text file. The fields of a line of the text file are
/// separated by semicolons, tabs, commas or blanks. Lines of the text file that begin with # are
/// comments. The first line of the text file, or the last comment before the numbers, may contain
/// column names.
struct NumberTable {
  std::string source;              ///< name of the file, for messages
  std::vector<std::string> names;  ///< column names in lower case without units; may be empty
  std::vector<std::vector<double>> rows;  ///< rows of finite numbers; all rows have the same length
  std::vector<int> lines;                 ///< line number of each row, from 1

  std::size_t column_count() const { return rows.front().size(); }
  std::vector<double> column_values(std::size_t c) const;
  /// @throws InputError with the message "SOURCE:LINE: problem" that states the line of the row
  [[noreturn]] void throw_row_error(std::size_t row, const std::string& problem) const;
};

/// Largest accepted magnitude of abscissae, densities and integrals; fourth powers of accepted
/// numbers divided by the narrowest bin width are finite.
inline constexpr double kMaxMagnitude = 1e60;

enum class NumberTableContent { density, samples };

/// A density has two or three columns. Samples have one to three columns, and as many rows as a
/// joint density.
/// @param source name of the file, for messages
/// @throws InputError with a message of one line that states the source and the line number
NumberTable read_number_table(std::istream& in, const std::string& source,
                              NumberTableContent content = NumberTableContent::density);

/// Returns the samples of a table with the columns y; y, y'; or t, y, y', in any order if the
/// columns have names.
/// @throws InputError if no column has the name of a displacement, a name is unknown, or the times
/// are not equidistant within half of their mean interval
StateSamples samples_from_table(const NumberTable& table);

/// The quantity in the third column of a histogram.
enum class HistogramQuantity { density, probability, count };
inline constexpr base::EnumEntry<HistogramQuantity> kHistogramQuantityNames[] = {
    {HistogramQuantity::density, "density"},
    {HistogramQuantity::probability, "probability"},
    {HistogramQuantity::count, "count"}};
constexpr const auto& enumerator_names(HistogramQuantity) { return kHistogramQuantityNames; }
constexpr std::string_view name(HistogramQuantity value) { return base::name_of(value); }

/// Returns the variable (y or y') of a marginal density by the names of the columns. For unknown
/// column names, the variable is y' if an abscissa is negative, otherwise y.
transform::StateVariable variable_from_column_names(const NumberTable& table);

/// Returns the index of the column of y' if the column names are y, y', p or y', y, p (a joint
/// density). For all other column names, velocity_column_index() returns the number of names.
std::size_t velocity_column_index(const std::vector<std::string>& names);

/// Returns whether the columns of a table are a histogram: lower edge, upper edge and value of each
/// bin. A table without column names is a histogram if each bin begins near the end of the previous
/// bin.
bool is_histogram(const NumberTable& table);

/// Returns whether the bin `next` begins at the end of the bin `bin`, within rounding errors.
bool are_bins_adjacent(const std::vector<double>& bin, const std::vector<double>& next);

/// Returns the quantity of a histogram by the name of the third column. If the name of the third
/// column is unknown, the values determine the quantity: densities have the integral 1,
/// probabilities have the sum 1, and counts are integers. Values of a histogram that are neither
/// probabilities nor counts are densities.
HistogramQuantity detect_histogram_quantity(const NumberTable& histogram);

}  // namespace fpkcheck::methods
