#pragma once

#include <string>

namespace fpkcheck::report {

/// An L1 distance as text for tables: five decimals, two digits below 1e-4.
std::string l1_text(double l1);

}  // namespace fpkcheck::report
