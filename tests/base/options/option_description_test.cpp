#include "base/options/option_description.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "base/input_error.hpp"
#include "refusal.hpp"

namespace fpkcheck::base {

enum class Colour { red, green };
constexpr EnumEntry<Colour> kColourNames[] = {{Colour::red, "red"}, {Colour::green, "dark-green"}};
constexpr const auto& enumerator_names(Colour) { return kColourNames; }

namespace {

struct Paint {
  Colour colour = Colour::red;
  int coats = 2;
  double gloss = 0.5;
  std::optional<double> litres{};
  std::optional<Colour> primer{};
  bool wet = false;
  std::string maker = "us";
  std::uint64_t batch = 1;
};

const OptionsDescription<Paint>& paint() {
  static const auto description =
      OptionsDescription<Paint>("paint.")
          .add("colour", &Paint::colour, {"C", "of the top coat"})
          .add("coats", &Paint::coats, {"N", "how many"}, even_integers_between(2, 8))
          .add("gloss_share", &Paint::gloss, {"G", "how shiny"}, open_interval(0, 1))
          .add("litres", &Paint::litres, {"L", "how much"}, positive_numbers())
          .add("primer", &Paint::primer, {"C", "below"})
          .add("wet", &Paint::wet, {"", "not yet dry"})
          .add("maker", &Paint::maker, {"M", "who"})
          .without_flag()
          .add("batch", &Paint::batch, {"B", "which"});
  return description;
}

Values with(Values values, const std::string& name, const Value& value) {
  for (auto& named : values) {
    if (named.name == name) named.value = value;
  }
  return values;
}

using tests::refusal;

TEST(Description, ValuesRoundTrip) {
  const Paint changed{.colour = Colour::green,
                      .coats = 4,
                      .gloss = 0.25,
                      .litres = 3,
                      .primer = Colour::green,
                      .wet = true,
                      .maker = "them",
                      .batch = 1ull << 40};
  const Values values = paint().values(changed);
  EXPECT_EQ(paint().values(paint().read(values, "options")), values);
  const Values defaults = paint().values({});
  for (std::size_t k = 0; k < values.size(); ++k)
    EXPECT_NE(values[k], defaults[k]) << values[k].name;
  EXPECT_EQ(paint().values(paint().read(defaults, "options")), defaults);
}

TEST(Description, AcceptsIntegersAsNumbersOnly) {
  const Values defaults = paint().values({});
  EXPECT_EQ(paint().read(with(defaults, "litres", std::int64_t{3}), "options").litres, 3.0);
  EXPECT_NE(refusal([&] {
              paint().read(with(defaults, "coats", 4.0), "options");
            }).find("options.coats = 4 (must be an even number from 2 to 8)"),
            std::string::npos);
}

TEST(Description, NamesMissingUnknownAndMistypedValues) {
  const Values defaults = paint().values({});
  for (const auto& named : defaults) {
    Values without;
    for (const auto& other : defaults) {
      if (other.name != named.name) without.push_back(other);
    }
    EXPECT_NE(refusal([&] {
                paint().read(without, "options");
              }).find("options." + named.name + " is missing"),
              std::string::npos);
    const Value wrong = std::holds_alternative<bool>(named.value) ? Value(1.5) : Value(true);
    EXPECT_NE(refusal([&] {
                paint().read(with(defaults, named.name, wrong), "options");
              }).find("options." + named.name + " = "),
              std::string::npos);
  }
  Values more = defaults;
  more.push_back({"smell", true});
  EXPECT_NE(refusal([&] { paint().read(more, "options"); }).find("options.smell is unknown"),
            std::string::npos);
  EXPECT_NE(refusal([&] {
              paint().read(with(defaults, "colour", std::string("blue")), "options");
            }).find("options.colour = 'blue' (must be one of red, dark-green)"),
            std::string::npos);
  EXPECT_NE(refusal([&] {
              paint().read(with(defaults, "batch", std::int64_t{-1}), "options");
            }).find("options.batch = -1"),
            std::string::npos);
}

// A parameter whose key did not exist when the file was written.
TEST(Description, DefaultReplacesMissingValue) {
  const auto description = OptionsDescription<Paint>("paint.")
                               .add("coats", &Paint::coats, {"N", "how many"})
                               .add("wet", &Paint::wet, {"", "not yet dry"})
                               .with_default(true);
  EXPECT_TRUE(description.read({{"coats", std::int64_t{3}}}, "options").wet);
  EXPECT_THROW(description.read({{"wet", true}}, "options"), InputError);
}

TEST(Description, ValidatesRangesAndAcceptsAutomatic) {
  EXPECT_NO_THROW(paint().validate({}));
  EXPECT_EQ(refusal([] { paint().validate({.coats = 3}); }),
            "paint.coats = 3 (must be an even number from 2 to 8)");
  EXPECT_EQ(refusal([] { paint().validate({.gloss = 1}); }),
            "paint.gloss_share = 1 (must be above 0 and below 1)");
  EXPECT_EQ(refusal([] { paint().validate({.litres = -1}); }),
            "paint.litres = -1 (must be a positive number)");
  EXPECT_NE(refusal([] {
              paint().validate({.litres = std::numeric_limits<double>::quiet_NaN()});
            }).find("paint.litres = nan"),
            std::string::npos);
}

TEST(Description, ParsesCommandLineTexts) {
  Paint p;
  const auto parse = [&](const char* name, const char* text) {
    paint().parse(p, *paint().find(name), text, std::string("--") + name);
  };
  parse("coats", "+4");
  parse("litres", "2e1");
  parse("primer", "dark-green");
  parse("wet", "true");
  EXPECT_EQ(p.coats, 4);
  EXPECT_EQ(p.litres, 20.0);
  EXPECT_EQ(p.primer, Colour::green);
  EXPECT_TRUE(p.wet);
  parse("litres", "auto");
  EXPECT_FALSE(p.litres);
  EXPECT_EQ(refusal([&] { parse("coats", "4x"); }), "--coats '4x' (not an integer)");
  EXPECT_EQ(refusal([&] { parse("litres", ""); }), "--litres '' (not a number)");
  EXPECT_EQ(refusal([&] { parse("litres", "1e999"); }),
            "--litres '1e999' (out of the range of double precision)");
  EXPECT_EQ(refusal([&] { parse("colour", "auto"); }),
            "--colour 'auto' (must be one of red, dark-green)");
}

TEST(Description, DerivesFlagsFromNames) {
  EXPECT_EQ(paint().find("gloss_share")->flag, "gloss-share");
  EXPECT_EQ(paint().find("maker")->flag, "");
}

}  // namespace
}  // namespace fpkcheck::base
