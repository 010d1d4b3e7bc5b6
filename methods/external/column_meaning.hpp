#pragma once

#include <string_view>

#include "methods/external/number_table.hpp"
#include "transform/marginal.hpp"

namespace fpkcheck::methods {

/// The quantity in the third column of a histogram.
enum class HistogramQuantity { density, probability, count };

/// The name of the quantity in summaries: "density", "probability", "count".
std::string_view name(HistogramQuantity value);

/// The variable of a marginal density, y or y', from the names of the columns. If the names
/// identify no variable, the variable is y' if any abscissa is negative, else y.
transform::Variable variable_from_names(const NumberTable& table);

/// The index of the column of y' if the names are those of a joint density: y, y' and p, or y', y
/// and p. For other names, the result is the number of names.
std::size_t velocity_column_index(const std::vector<std::string>& names);

/// Whether the columns are a histogram: lower edge, upper edge and value of bins. The names of the
/// columns decide. Without names, a table is a histogram if each bin begins near the end of the
/// previous bin.
bool is_histogram(const NumberTable& table);

/// Whether the bin `next` begins at the end of `bin`, within rounding of the last digits.
bool are_adjacent(const std::vector<double>& bin, const std::vector<double>& next);

/// The quantity of the values of a histogram, from the name of the third column. Without a known
/// name, the values are densities if their integral is 1, else probabilities if their sum is 1,
/// else counts if all values are integers, else densities.
HistogramQuantity detect_histogram_quantity(const NumberTable& histogram);

}  // namespace fpkcheck::methods
