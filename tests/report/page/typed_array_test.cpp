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
}

TEST(TypedArray, NamesItsTypeInJson) {
  EXPECT_EQ(nlohmann::ordered_json(float_array(std::vector{1.0})).dump(),
            R"({"dtype":"f4","bdata":"AACAPw=="})");
}

}  // namespace
}  // namespace fpkcheck::report
