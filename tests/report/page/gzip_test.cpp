#include "report/page/gzip.hpp"

#include <gtest/gtest.h>

#include "gunzip_base64.hpp"

namespace fpkcheck::report {
namespace {

TEST(Gzip, IsUnpackedUnchanged) {
  for (const std::size_t size : {0, 1, 2, 3, 100'000}) {
    std::string text;
    for (std::size_t k = 0; k < size; ++k) text += static_cast<char>(k * k % 251);
    EXPECT_EQ(tests::gunzip_base64(gzip_base64(text)), text) << size;
  }
}

TEST(Gzip, OfTheSameTextIsTheSameAndSmaller) {
  const std::string text(10'000, 'x');
  EXPECT_EQ(gzip_base64(text), gzip_base64(text));
  EXPECT_LT(gzip_base64(text).size(), 200u);
}

}  // namespace
}  // namespace fpkcheck::report
