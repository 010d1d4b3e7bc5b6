#include "workflows/sweep/report/figure/status_mark.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace fpkcheck::sweep {

using transform::Status;

int point_type(Status status) {
  switch (status) {
    case Status::ok:
      break;
    case Status::not_converged:
      return 1;  // a plus
    case Status::ill_posed:
      return 8;  // a triangle
    case Status::inaccurate:
      return 7;  // a dot
    case Status::inadmissible:
      return 2;  // a cross
    case Status::failed:
      return 3;  // a star
    case Status::not_offered:
      return 4;  // a square
  }
  return 0;
}

std::string mark_style(int point_type, double size) {
  constexpr int kDot = 7;  // filled: a large dot would hide the colour
  return fmt::format("with points lc rgb 'black' lw 1.2 pt {} ps {:.3g}", point_type,
                     point_type == kDot ? size / 2 : size);
}

std::vector<report::LegendEntry> status_legend(const std::vector<Status>& statuses) {
  std::vector<report::LegendEntry> entries;
  for (const auto& [status, name, meaning] : transform::kStatusNames) {
    if (status == Status::ok || std::ranges::count(statuses, status) == 0) continue;
    entries.push_back({"NaN " + mark_style(point_type(status)), std::string(name)});
  }
  return entries;
}

}  // namespace fpkcheck::sweep
