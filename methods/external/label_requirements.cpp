#include "methods/external/label_requirements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "base/input_error.hpp"
#include "base/text/sanitise.hpp"
#include "results/output_directory.hpp"

namespace fpkcheck::methods {
namespace {

// The name of a variable or data block for a label: "a_b" for both "a.b" and "a-b".
std::string label_as_identifier(std::string label) {
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
    const std::string plain = label_as_identifier(label);
    if (plain == solver.name || plain.starts_with(solver.name + '_')) {
      throw InputError(
          fmt::format("label '{}' is the name of a method; choose another label", label));
    }
  }
}

void require_distinct_labels(const std::string& one, const std::string& other) {
  if (one == other || label_as_identifier(one) != label_as_identifier(other)) return;
  throw InputError(fmt::format(
      "labels '{}' and '{}' differ only in '-', '_' or '.'; choose another label", one, other));
}

}  // namespace fpkcheck::methods
