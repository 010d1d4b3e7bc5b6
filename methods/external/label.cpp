#include "methods/external/label.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "base/input_error.hpp"
#include "base/text/sanitise.hpp"
#include "results/directory.hpp"

namespace fpkcheck::methods {
namespace {

// The name of a variable or data block for a label: "a_b" for both "a.b" and "a-b".
std::string identifier_of(std::string label) {
  std::ranges::replace_if(
      label, [](unsigned char c) { return !std::isalnum(c); }, '_');
  return label;
}

}  // namespace

void require_valid_label(const std::string& label, const Registry& registry) {
  constexpr std::size_t kMaxLength = 24;  // longer labels do not fit a table of 80 columns
  const bool legal =
      !label.empty() && label.size() <= kMaxLength && results::file_stem(label) == label;
  if (!legal) {
    throw InputError(
        fmt::format("label {} of a density (must be 1 to {} letters, digits, '-', '_' or '.')",
                    base::in_quotes(label), kMaxLength));
  }
  for (const auto& solver : registry.solvers()) {
    const std::string plain = identifier_of(label);
    if (plain == solver.name || plain.starts_with(solver.name + '_')) {
      throw InputError(
          fmt::format("label '{}' is the name of a method; choose another label", label));
    }
  }
}

void require_distinct_labels(const std::string& one, const std::string& other) {
  if (one == other || identifier_of(one) != identifier_of(other)) return;
  throw InputError(fmt::format(
      "labels '{}' and '{}' differ only in '-', '_' or '.'; choose another label", one, other));
}

}  // namespace fpkcheck::methods
