#include "results/json_conversions.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "base/input_error.hpp"
#include "refusal.hpp"

namespace fpkcheck::results {
namespace {

Json json_of(const std::string& text) {
  std::istringstream in(text);
  return parse_json(in, "x.json");
}

std::string refusal_of(const std::string& text) {
  return tests::refusal([&] { json_of(text); });
}

TEST(Json, IsReadWithinLimits) {
  const auto starts = [](const std::string& text, const char* with) {
    return refusal_of(text).starts_with(with);
  };
  EXPECT_TRUE(starts(std::string(100000, '['), "x.json is nested more than 32 deep"));
  std::string many = "[0";
  for (int k = 0; k < 2'000'001; ++k) many += ",0";
  EXPECT_TRUE(starts(many + ']', "x.json has more than 2000000 values"));
  EXPECT_TRUE(starts("[\"" + std::string(2'000'000, 'x') + "\"]", "x.json has a text of 2000000"));
  EXPECT_TRUE(starts("[1e999]", "x.json is not JSON"));
  EXPECT_LT(refusal_of("[1" + std::string(1'000'000, '0') + "e999]").size(), 200u);
}

// Writing the path of the key "a[" did not terminate.
TEST(Json, KeysMustNotContainPathSeparators) {
  for (const char* key : {"", ".", "a.b", "a[", "a[1000000000]", "[]", "]", "a[]"}) {
    const Json json{{"nested", {{key, 1}}}};
    EXPECT_THROW(metrics_from_json(json), InputError) << key;
    EXPECT_THROW(metrics_from_json(json.at("nested")), InputError) << key;
  }
  EXPECT_EQ(metrics_from_json(json_of(R"({"a": {"b": [1, 2]}})")).at(1).path, "a.b[1]");
}

TEST(Json, ControlCharactersAreEscaped) {
  const std::string red = "{\"a\": \"\\u001b[31m\\n\"}", greek = "{\"a\": \"p(y′), σ\"}";
  EXPECT_EQ(json_of(red).at("a"), "\\x1b[31m\\x0a");
  EXPECT_EQ(json_of(greek).at("a"), "p(y′), σ");
}

}  // namespace
}  // namespace fpkcheck::results
