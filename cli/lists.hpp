#pragma once

#include <string>
#include <vector>

namespace fpkcheck::cli {

/// The items of a list separated by commas, each once, as they come.
/// @throws InputError naming the option when there is none
std::vector<std::string> items(const std::string& option, const std::string& list);

/// The same, as whole numbers.
/// @throws InputError naming the option and the item that is no number
std::vector<int> integers(const std::string& option, const std::string& list);

}  // namespace fpkcheck::cli
