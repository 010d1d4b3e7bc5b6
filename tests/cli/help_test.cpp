#include "cli/help.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace fpkcheck::cli {
namespace {

std::size_t longest_line(const std::string& text) {
  std::size_t longest = 0;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) longest = std::max(longest, line.size());
  return longest;
}

constexpr const char* kHead = R"(usage: fpkcheck cook CASE [options]

A paragraph of two lines, the first of which is longer than what is asked for, and goes on in a
second one.

  slow   for hours, over a low flame that nobody ever looks at, until there is nothing left to cook
         and nobody left to eat
  quick  at once

examples:
  fpkcheck cook case1
  fpkcheck cook case1 --flame low --pot copper --spoon wooden --time 7200      (a slow one)
)";

TEST(Help, KeepsUsageTextsThatFit) { EXPECT_EQ(wrap_usage(kHead, 100), kHead); }

TEST(Help, WrapsUsageTextsToTheWidth) {
  EXPECT_EQ(wrap_usage(kHead, 60), R"(usage: fpkcheck cook CASE [options]

A paragraph of two lines, the first of which is longer than
what is asked for, and goes on in a second one.

  slow   for hours, over a low flame that nobody ever looks
         at, until there is nothing left to cook and nobody
         left to eat
  quick  at once

examples:
  fpkcheck cook case1
  fpkcheck cook case1 --flame low --pot copper --spoon \
      wooden --time 7200
      (a slow one)
)");
}

TEST(Help, AlignsOptionsIndependentlyOfLongNames) {
  const CommandHelpText help{
      "usage: cook\n",
      {{.name = "--flame", .placeholder = "F", .default_value = "low", .text = "how hot"},
       {.name = "--quiet", .short_name = "-q", .text = "without a word of what it does"},
       {.name = "--a-name-of-unusual-length", .placeholder = "N", .text = "of it"}}};
  EXPECT_EQ(help_text(help, 40), R"(usage: cook

options:
  --flame F (=low)  how hot
  -q, --quiet       without a word of
                    what it does
  --a-name-of-unusual-length N
                    of it
)");
}

TEST(Help, IsCaptured) {
  boost::program_options::options_description options;
  options.add_options()("flame,f",
                        boost::program_options::value<int>()->value_name("F")->default_value(3),
                        "how hot");
  const auto help = capture_help([&] { print_or_capture_help("usage: cook\n", options); });
  EXPECT_EQ(help.usage, "usage: cook\n");
  ASSERT_EQ(help.options.size(), 1u);
  EXPECT_EQ(help.options[0].name, "--flame");
  EXPECT_EQ(help.options[0].short_name, "-f");
  EXPECT_EQ(help.options[0].placeholder, "F");
  EXPECT_EQ(help.options[0].default_value, "3");
  EXPECT_LE(longest_line(help_text(help, 30)), 30u);
}

}  // namespace
}  // namespace fpkcheck::cli
