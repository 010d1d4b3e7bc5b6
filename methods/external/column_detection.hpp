#pragma once

#include <string_view>

#include "methods/external/number_table.hpp"
#include "transform/marginal.hpp"

namespace fpkcheck::methods {

/// The quantity in the third column of a histogram.
enum class HistogramQuantity { density, probability, count };

std::string_view name(HistogramQuantity value);

/// Returns the variable of a marginal density, y or y', by the names of the columns. Without known
/// names the variable is y' if an abscissa is negative, else y.
transform::StateVariable variable_from_column_names(const NumberTable& table);

/// Returns the index of the column of y' if the names are those of a joint density in the order y,
/// y', p or y', y, p. For other names the result is the number of names.
std::size_t velocity_column_index(const std::vector<std::string>& names);

/// Returns whether the columns are a histogram: lower edge, upper edge and value of each bin.
/// Without column names, a table is a histogram if each bin begins near the end of the previous
/// bin.
bool is_histogram(const NumberTable& table);

/// Returns whether the bin `next` begins at the end of `bin`, within rounding errors.
bool are_bins_adjacent(const std::vector<double>& bin, const std::vector<double>& next);

/// Returns the quantity of a histogram by the name of the third column. Without a known name, the
/// values are densities if their integral is 1, else probabilities if their sum is 1, else counts
/// if all values are integers, else densities.
HistogramQuantity detect_histogram_quantity(const NumberTable& histogram);

}  // namespace fpkcheck::methods
