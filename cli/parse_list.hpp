#pragma once

#include <string>
#include <vector>

namespace fpkcheck::cli {

/// Splits a comma-separated list; returns its distinct entries in the order of the list.
/// @param option name of the option, for error messages
/// @throws InputError for an empty list
std::vector<std::string> parse_list(const std::string& option, const std::string& list);

/// Parses a comma-separated list of whole numbers; returns the distinct numbers in the order of the
/// list.
/// @throws InputError for an empty list or an item that is not an integer
std::vector<int> parse_integers(const std::string& option, const std::string& list);

}  // namespace fpkcheck::cli
