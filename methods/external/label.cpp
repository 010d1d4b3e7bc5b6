#include "methods/external/label.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "base/input_error.hpp"
#include "base/text/sanitise.hpp"
#include "results/directory.hpp"

namespace fpkcheck::methods {
namespace {

// As names of variables and of blocks of data have it: "a.b" and "a-b" would be one there.
std::string plain_name(std::string label) {
  std::ranges::replace_if(
      label, [](unsigned char c) { return !std::isalnum(c); }, '_');
  return label;
}

}  // namespace

void require_free(const std::string& label, const Registry& registry) {
  constexpr std::size_t kLongest = 24;  // the table has 80 columns
  const bool legal =
      !label.empty() && label.size() <= kLongest && results::file_stem(label) == label;
  if (!legal) {
    throw InputError(
        fmt::format("label {} of a density (must be 1 to {} letters, digits, '-', '_' or '.')",
                    base::in_quotes(label), kLongest));
  }
  for (const auto& solver : registry.solvers()) {
    const std::string plain = plain_name(label);
    if (plain == solver.name || plain.starts_with(solver.name + '_')) {
      throw InputError(fmt::format(
          "label '{}' is a method's (choose another for a density of your own)", label));
    }
  }
}

void require_unlike(const std::string& one, const std::string& other) {
  if (one == other || plain_name(one) != plain_name(other)) return;
  throw InputError(fmt::format(
      "labels '{}' and '{}' are too alike (they differ in '-', '_' or '.' alone: choose another)",
      one, other));
}

}  // namespace fpkcheck::methods
