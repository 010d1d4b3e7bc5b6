#pragma once

#include <string>
#include <vector>

namespace fpkcheck::problem {

/// A case file that is compiled into the program: the paper's Table 1.
struct NamedCase {
  std::string name;
  std::string text;  ///< the contents of cases/NAME.ini
};

/// The paper's four cases, in its order.
const std::vector<NamedCase>& named_cases();

}  // namespace fpkcheck::problem
