#pragma once

#include <istream>
#include <ostream>
#include <type_traits>
#include <vector>

namespace fpkcheck::mcs {

/// Binary form of numbers, for files that the same machine reads and writes.
template <class Number>
requires std::is_trivially_copyable_v<Number>
void write_binary(std::ostream& out, const Number& number) {
  out.write(reinterpret_cast<const char*>(&number), sizeof number);
}
template <class Number>
requires std::is_trivially_copyable_v<Number>
void read_binary(std::istream& in, Number& number) {
  in.read(reinterpret_cast<char*>(&number), sizeof number);
}

/// Binary form of mostly zero lists: runs of zeros are stored as their length.
void write_binary(std::ostream& out, const std::vector<double>& numbers);
/// @param numbers of the expected size; any size where empty
/// @throws InputError where the size or the form differs
void read_binary(std::istream& in, std::vector<double>& numbers);

}  // namespace fpkcheck::mcs
