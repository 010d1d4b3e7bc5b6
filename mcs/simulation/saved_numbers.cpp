#include "mcs/simulation/saved_numbers.hpp"

#include <cstdint>

#include "base/input_error.hpp"

namespace fpkcheck::mcs {
namespace {

constexpr std::uint64_t kMost = 100000;  // limit where the number of entries is free

void require(bool holds) {
  if (!holds) throw InputError("wrong number of entries");
}

}  // namespace

void put(std::ostream& out, const std::vector<double>& numbers) {
  put(out, std::uint64_t{numbers.size()});
  for (std::size_t k = 0; k < numbers.size();) {
    std::size_t zeros = k;
    while (zeros < numbers.size() && numbers[zeros] == 0) ++zeros;
    std::size_t end = zeros;
    while (end < numbers.size() && numbers[end] != 0) ++end;
    put(out, std::uint64_t{zeros - k});
    put(out, std::uint64_t{end - zeros});
    for (std::size_t i = zeros; i < end; ++i) put(out, numbers[i]);
    k = end;
  }
}

void get(std::istream& in, std::vector<double>& numbers) {
  std::uint64_t size = 0;
  get(in, size);
  require(in && (numbers.empty() ? size <= kMost : size == numbers.size()));
  numbers.assign(size, 0.0);
  for (std::uint64_t k = 0; k < size;) {
    std::uint64_t zeros = 0, others = 0;
    get(in, zeros);
    get(in, others);
    require(in && zeros <= size - k && others <= size - k - zeros && zeros + others > 0);
    k += zeros;
    for (const std::uint64_t end = k + others; k < end; ++k) get(in, numbers[k]);
  }
  require(static_cast<bool>(in));
}

}  // namespace fpkcheck::mcs
