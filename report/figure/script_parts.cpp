#include "report/figure/script_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace fpkcheck::report {

std::string margins(const Place& place) {
  return fmt::format(
      "set lmargin at screen {:.4g}\nset rmargin at screen {:.4g}\n"
      "set tmargin at screen {:.4g}\nset bmargin at screen {:.4g}\n",
      place.left, place.right, place.top, place.bottom);
}

std::string data_block(const std::string& name, const std::string& rows) {
  return fmt::format("${} << EOD\n{}EOD\n", name, rows);
}

std::string density_of(transform::Variable variable) {
  return variable == transform::Variable::y ? "{/:Italic p}({/:Italic y})"
                                            : "{/:Italic p}({/:Italic y}')";
}

std::vector<SeriesLook> series_looks(std::span<const transform::Identity> identities) {
  constexpr std::array<std::pair<int, int>, 6> kMarks{
      {{7, 6}, {5, 4}, {9, 8}, {11, 10}, {13, 12}, {15, 14}}};
  std::vector<SeriesLook> looks;
  for (const auto& one : identities) {
    const auto of_its_family = std::ranges::count(identities.first(looks.size()), one.family,
                                                  &transform::Identity::family);
    const auto& [filled, open] = kMarks[looks.size() % kMarks.size()];
    looks.push_back({one.look.colour, filled, open, 1 + static_cast<int>(of_its_family)});
  }
  return looks;
}

}  // namespace fpkcheck::report
