#include "report/budget/part_look.hpp"

#include "compare/budget.hpp"

namespace fpkcheck::report {
namespace {

struct PartLook {
  const char* colour;
  const char* pattern;
};

// Hues of Okabe and Ito, which colour-blind readers tell apart.
PartLook look_of(const std::string& part) {
  using compare::Link;
  const auto links = compare::links_named(part);
  if (links.size() > 1) return {"#999999", "."};
  switch (links.front()) {
    case Link::closure:
      return {"#D55E00", ""};
    case Link::impact:
      return {"#E69F00", "/"};
    case Link::truncation:
      return {"#0072B2", ""};
    case Link::white_noise:
      return {"#009E73", "|"};
    case Link::discretisation:
      return {"#56B4E9", "\\"};
    case Link::sampling:
      break;
  }
  return {"#CC79A7", "x"};
}

}  // namespace

const char* part_colour(const std::string& part) { return look_of(part).colour; }

const char* part_pattern(const std::string& part) { return look_of(part).pattern; }

}  // namespace fpkcheck::report
