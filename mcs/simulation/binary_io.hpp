#pragma once

#include <istream>
#include <ostream>
#include <type_traits>
#include <vector>

namespace fpkcheck::mcs {

/// Writes a number in the binary form of this machine, for files that the same machine reads.
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

/// Writes a list of numbers in binary form. A run of zeros is stored as its length, since most
/// lists consist mainly of zeros.
void write_binary(std::ostream& out, const std::vector<double>& numbers);
/// Reads a list of numbers that write_binary() wrote.
/// @param numbers a list of the expected size; an empty list accepts any size
/// @throws InputError if the file has another size or is not in this form
void read_binary(std::istream& in, std::vector<double>& numbers);

}  // namespace fpkcheck::mcs
