#pragma once

#include <string_view>

#include "methods/external/number_table.hpp"
#include "transform/marginal.hpp"

namespace fpkcheck::methods {

/// The meaning of the third column of a histogram.
enum class BinValue { density, probability, count };

/// The name in summaries: "density", "probability", "count".
std::string_view name(BinValue value);

/// The variable by the names of the columns; without such names, y' if any abscissa is negative.
transform::Variable variable_from_names(const NumberTable& table);

/// The index of the column of y' where the names are those of y, y' and a joint density p, with y
/// and y' in either order. Otherwise the number of names.
std::size_t velocity_column_index(const std::vector<std::string>& names);

/// Whether the columns are lower edge, upper edge and value of bins. The names decide; without
/// names, each bin must begin near the end of the previous bin.
bool is_histogram(const NumberTable& table);

/// Whether a bin begins at the end of the previous bin, within rounding of the last digits.
bool are_adjacent(const std::vector<double>& bin, const std::vector<double>& next);

/// The meaning of a histogram's values by the name of the column. Without a known name: a density
/// if its integral is 1, probabilities if the sum is 1, counts if all values are integers,
/// otherwise a density.
BinValue detect_bin_value(const NumberTable& histogram);

}  // namespace fpkcheck::methods
