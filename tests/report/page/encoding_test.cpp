#include "report/page/encoding.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "gunzip_base64.hpp"

namespace fpkcheck::report {
namespace {

std::string encoded(const std::string& text) {
  return encode_base64(std::as_bytes(std::span(text)));
}

TEST(Base64, IsThatOfRfc4648) {
  EXPECT_EQ(encoded(""), "");
  EXPECT_EQ(encoded("f"), "Zg==");
  EXPECT_EQ(encoded("fo"), "Zm8=");
  EXPECT_EQ(encoded("foo"), "Zm9v");
  EXPECT_EQ(encoded("foob"), "Zm9vYg==");
  EXPECT_EQ(encoded("\xff\xfe"), "//4=");
}

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

TEST(TypedArray, IsLittleEndianBase64) {
  // 1.0f is 00 00 80 3f, -2.0f is 00 00 00 c0.
  EXPECT_EQ(float_array(std::vector{1.0}).bdata, "AACAPw==");
  EXPECT_EQ(float_array(std::vector{1.0, -2.0}).bdata, "AACAPwAAAMA=");
  EXPECT_EQ(float_array(std::vector{1.0, -2.0, 1.0}).bdata, "AACAPwAAAMAAAIA/");
}

TEST(TypedArray, NamesItsTypeInJson) {
  EXPECT_EQ(nlohmann::ordered_json(float_array(std::vector{1.0})).dump(),
            R"({"dtype":"f4","bdata":"AACAPw=="})");
}

}  // namespace
}  // namespace fpkcheck::report
