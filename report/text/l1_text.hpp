#pragma once

#include <string>

namespace fpkcheck::report {

/// The text of an L1 distance in tables: five decimals; two significant digits for distances below
/// 1e-4.
std::string l1_text(double l1);

}  // namespace fpkcheck::report
