#pragma once

#include <string>
#include <vector>

namespace fpkcheck::cli {

/// The distinct entries of a comma-separated list, in the order of the list.
/// @param option name of the option, for the message
/// @throws InputError for an empty list
std::vector<std::string> parse_list(const std::string& option, const std::string& list);

/// The distinct whole numbers of a comma-separated list, in the order of the list.
/// @throws InputError for an empty list or an item that is not an integer
std::vector<int> parse_integers(const std::string& option, const std::string& list);

}  // namespace fpkcheck::cli
