#pragma once

#include <istream>
#include <ostream>
#include <type_traits>
#include <vector>

namespace fpkcheck::mcs {

/// Numbers as they lie in memory: for files that are read by the machine that wrote them.
template <class Number>
requires std::is_trivially_copyable_v<Number>
void put(std::ostream& out, const Number& number) {
  out.write(reinterpret_cast<const char*>(&number), sizeof number);
}
template <class Number>
requires std::is_trivially_copyable_v<Number>
void get(std::istream& in, Number& number) {
  in.read(reinterpret_cast<char*>(&number), sizeof number);
}

/// Lists that are mostly 0: runs of zeros are stored as their length.
void put(std::ostream& out, const std::vector<double>& numbers);
/// @param numbers as many as are expected; any number of them when empty
/// @throws InputError when there are others, or what is read is no such list
void get(std::istream& in, std::vector<double>& numbers);

}  // namespace fpkcheck::mcs
