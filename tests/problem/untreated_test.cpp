#include "problem/untreated.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "problem/named_cases.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::problem {
namespace {

TEST(Untreated, IsKnownByEachOfItsWordsInKeysAndCommands) {
  for (const auto& [subject, words] : untreated()) {
    ASSERT_FALSE(words.empty()) << subject;
    for (const std::string_view each : words) {
      const std::string word(each);
      for (const std::string& name :
           {word, "system." + word, word + ".amplitude", "system.dry_" + word, "first-" + word}) {
        EXPECT_NE(untreated_text(name).find(subject), std::string::npos) << name;
      }
    }
  }
  EXPECT_EQ(untreated_text("system.colour"), "");
  EXPECT_EQ(untreated_text("solve"), "");
}

// No key of the program is reported as unsupported.
TEST(Untreated, IsNoKeyThatTheProgramHas) {
  for (const base::Descriptions* section : case_descriptions()) {
    for (const auto& parameter : section->all()) {
      EXPECT_EQ(untreated_text(section->prefix() + parameter.name), "") << parameter.name;
    }
  }
}

TEST(Untreated, IsListedInTheReadme) {
  std::ifstream in(FPKCHECK_README);
  const std::string readme(std::istreambuf_iterator<char>(in), {});
  const auto begin = readme.find("## What it does not treat");
  ASSERT_NE(begin, std::string::npos);
  const std::string section = readme.substr(begin, readme.find("\n## ", begin + 1) - begin);
  for (const auto& [subject, words] : untreated()) {
    EXPECT_NE(section.find(subject), std::string::npos) << subject;
  }
}

}  // namespace
}  // namespace fpkcheck::problem
