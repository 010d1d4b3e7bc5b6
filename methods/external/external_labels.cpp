#include "methods/external/external_labels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <string>
#include <string_view>

#include "base/input_error.hpp"
#include "base/text/printable_text.hpp"
#include "methods/plot_style.hpp"
#include "results/output_directory.hpp"

namespace fpkcheck::methods {
namespace {

// Returns the netCDF variable or gnuplot data block of a label: "a_b" for "a.b" and "a-b".
std::string label_as_identifier(std::string label) {
  std::ranges::replace_if(
      label, [](unsigned char c) { return !std::isalnum(c); }, '_');
  return label;
}

constexpr std::string_view kSeparators = "-_.";

bool is_separator(char c) { return kSeparators.find(c) != std::string_view::npos; }

// Returns the family name in a label: "chi" for the label "chi-n4" of a density of order 4. The
// family name is empty if the label does not end with the order.
std::optional<std::string> family_name(const transform::SolutionIdentity& identity) {
  if (!identity.order) return std::nullopt;
  std::string_view name = identity.id;
  const std::string order = std::to_string(*identity.order);
  if (!name.ends_with(order)) return std::nullopt;
  name.remove_suffix(order.size());
  if (name.size() > 1 && name.back() == 'n' && is_separator(name[name.size() - 2])) {
    name.remove_suffix(1);
  }
  while (!name.empty() && is_separator(name.back())) name.remove_suffix(1);
  // The label "chi12" has the order 12, not the order 2 of a name "chi1".
  if (name.empty() || ('0' <= name.back() && name.back() <= '9')) return std::nullopt;
  return std::string(name);
}

}  // namespace

void require_valid_label(const std::string& label, const SolverRegistry& registry) {
  constexpr std::size_t kMaxLength = 24;  // longer labels do not fit a table of 80 columns
  const bool legal =
      !label.empty() && label.size() <= kMaxLength && results::case_file_stem(label) == label;
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

void group_methods_into_families(std::span<Method> methods) {
  for (std::size_t first = 0; first < methods.size(); ++first) {
    const auto name = family_name(methods[first].identity);
    if (!name || methods[first].identity.family == *name) continue;
    const auto is_member = [&](const Method& method) {
      return family_name(method.identity) == name;
    };
    if (std::ranges::count_if(methods, is_member) < 2) continue;
    for (Method& method : methods) {
      if (!is_member(method)) continue;
      method.identity.family = *name;
      method.identity.plot_style = external_family_style(first, *method.identity.order);
    }
  }
}

}  // namespace fpkcheck::methods
