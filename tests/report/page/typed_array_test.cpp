#include "report/page/typed_array.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <vector>

namespace fpkcheck::report {
namespace {

TEST(TypedArray, IsLittleEndianBase64) {
  // 1.0f is 00 00 80 3f, -2.0f is 00 00 00 c0.
  EXPECT_EQ(float_array(std::vector{1.0}).bdata, "AACAPw==");
  EXPECT_EQ(float_array(std::vector{1.0, -2.0}).bdata, "AACAPwAAAMA=");
  EXPECT_EQ(float_array(std::vector{1.0, -2.0, 1.0}).bdata, "AACAPwAAAMAAAIA/");
  EXPECT_EQ(integer_array(std::vector<std::int16_t>{1, -2}).bdata, "AQD+/w==");
}

TEST(TypedArray, NamesItsTypeInJson) {
  EXPECT_EQ(nlohmann::ordered_json(float_array(std::vector{1.0})).dump(),
            R"({"dtype":"f4","bdata":"AACAPw=="})");
  EXPECT_EQ(nlohmann::json(integer_array({})).at("dtype"), "i2");
}

}  // namespace
}  // namespace fpkcheck::report
