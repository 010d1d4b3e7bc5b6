#include "cli/parse_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <sstream>

#include "base/input_error.hpp"
#include "base/text/sanitise.hpp"

namespace fpkcheck::cli {

std::vector<std::string> parse_list(const std::string& option, const std::string& list) {
  std::vector<std::string> result;
  std::istringstream stream(list);
  for (std::string item; std::getline(stream, item, ',');) {
    if (std::ranges::find(result, item) == result.end()) result.push_back(item);
  }
  if (result.empty()) {
    throw InputError(fmt::format("{}: the list is empty; give items separated by commas", option));
  }
  return result;
}

std::vector<int> parse_integers(const std::string& option, const std::string& list) {
  std::vector<int> result;
  for (const auto& item : parse_list(option, list)) {
    int value = 0;
    const auto [end, error] = std::from_chars(item.data(), item.data() + item.size(), value);
    if (error != std::errc{} || end != item.data() + item.size()) {
      throw InputError(fmt::format("{} {}: {} is not a valid integer; use a list such as 2,4,6",
                                   option, base::sanitise(list), base::in_quotes(item)));
    }
    if (std::ranges::find(result, value) == result.end()) result.push_back(value);
  }
  return result;
}

}  // namespace fpkcheck::cli
