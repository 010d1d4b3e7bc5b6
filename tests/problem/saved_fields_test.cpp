#include "problem/saved_fields.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "problem/energy_balance.hpp"
#include "problem/input_error.hpp"

namespace fpkcheck::problem {
namespace {

using Json = nlohmann::ordered_json;

std::string message(const Json& object, const std::function<void(SavedFields&)>& read) {
  try {
    SavedFields fields(object, "options");
    read(fields);
    fields.require_all_read();
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    return error.what();
  }
  return "accepted";
}

TEST(SavedFields, GiveBackWhatWasSaved) {
  const Json object = Json::parse(
      R"({"a": 0.1, "b": 3, "c": null, "d": null, "e": true, "f": "delta", "g": "word",
          "h": 18446744073709551615, "i": 2.5, "j": -4})");
  SavedFields fields(object, "options");
  EXPECT_EQ(fields.number("a"), 0.1);
  EXPECT_EQ(fields.number("b"), 3);
  EXPECT_EQ(fields.number_or_null("c"), std::nullopt);
  EXPECT_EQ(fields.integer_or_null("d"), std::nullopt);
  EXPECT_EQ(fields.flag("e"), true);
  EXPECT_EQ(fields.choice("f", {Impact::map, Impact::delta}), Impact::delta);
  EXPECT_EQ(fields.text("g"), "word");
  EXPECT_EQ(fields.count("h"), std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(fields.number_or_null("i"), 2.5);
  EXPECT_THROW(fields.require_all_read(), InputError);
  EXPECT_EQ(fields.integer("j"), -4);
  EXPECT_NO_THROW(fields.require_all_read());
}

TEST(SavedFields, SayOnOneLineWhatIsWrong) {
  const auto reads_number = [](SavedFields& f) { f.number("a"); };
  EXPECT_EQ(message(Json::array(), reads_number), "options is no JSON object");
  EXPECT_EQ(message({{"a", "x"}}, reads_number), "options.a = \"x\" (must be a number)");
  EXPECT_EQ(message({{"b", 1}}, reads_number),
            "options.a is missing (of another version of the program? run again)");
  EXPECT_EQ(message({{"a", 1}, {"b", 1}}, reads_number),
            "options.b is unknown (of another version of the program? run again)");
  EXPECT_EQ(message({{"a", 1}}, reads_number), "accepted");
  EXPECT_EQ(message({{"a", 1.5}}, [](SavedFields& f) { f.integer("a"); }),
            "options.a = 1.5 (must be an integer)");
  EXPECT_EQ(message({{"a", 3000000000}}, [](SavedFields& f) { f.integer("a"); }),
            "options.a = 3000000000 (must be an integer)");
  EXPECT_EQ(message({{"a", 18446744073709551615u}}, [](SavedFields& f) { f.integer("a"); }),
            "options.a = 18446744073709551615 (must be an integer)");
  EXPECT_EQ(message({{"a", -1}}, [](SavedFields& f) { f.count("a"); }),
            "options.a = -1 (must be an integer that is not negative)");
  EXPECT_EQ(message({{"a", 1}}, [](SavedFields& f) { f.flag("a"); }),
            "options.a = 1 (must be true or false)");
  EXPECT_EQ(message({{"a", nullptr}}, [](SavedFields& f) { f.text("a"); }),
            "options.a = null (must be a text)");
  EXPECT_EQ(message({{"a", "none"}},
                    [](SavedFields& f) {
                      f.choice("a", {Impact::map, Impact::delta});
                    }),
            "options.a = \"none\" (must be one of map, delta)");
}

}  // namespace
}  // namespace fpkcheck::problem
