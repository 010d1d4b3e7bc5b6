#include "mcs/simulation/binary_io.hpp"

#include <cstdint>

#include "base/input_error.hpp"

namespace fpkcheck::mcs {
namespace {

constexpr std::uint64_t kLargestFreeSize = 100000;  // limit if any number of entries is accepted

void require(bool holds) {
  if (!holds) throw InputError("wrong number of entries");
}

}  // namespace

void write_binary(std::ostream& out, const std::vector<double>& numbers) {
  write_binary(out, std::uint64_t{numbers.size()});
  for (std::size_t k = 0; k < numbers.size();) {
    std::size_t zeros = k;
    while (zeros < numbers.size() && numbers[zeros] == 0) ++zeros;
    std::size_t end = zeros;
    while (end < numbers.size() && numbers[end] != 0) ++end;
    write_binary(out, std::uint64_t{zeros - k});
    write_binary(out, std::uint64_t{end - zeros});
    for (std::size_t i = zeros; i < end; ++i) write_binary(out, numbers[i]);
    k = end;
  }
}

void read_binary(std::istream& in, std::vector<double>& numbers) {
  std::uint64_t size = 0;
  read_binary(in, size);
  require(in && (numbers.empty() ? size <= kLargestFreeSize : size == numbers.size()));
  numbers.assign(size, 0.0);
  for (std::uint64_t k = 0; k < size;) {
    std::uint64_t zeros = 0, others = 0;
    read_binary(in, zeros);
    read_binary(in, others);
    require(in && zeros <= size - k && others <= size - k - zeros && zeros + others > 0);
    k += zeros;
    for (const std::uint64_t end = k + others; k < end; ++k) read_binary(in, numbers[k]);
  }
  require(static_cast<bool>(in));
}

}  // namespace fpkcheck::mcs
