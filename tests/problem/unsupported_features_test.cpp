#include "problem/unsupported_features.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "problem/named_cases.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::problem {
namespace {

TEST(UnsupportedFeature, IsRecognisedInKeysAndCommands) {
  for (const auto& [subject, words] : unsupported_features()) {
    ASSERT_FALSE(words.empty()) << subject;
    for (const std::string_view each : words) {
      const std::string word(each);
      for (const std::string& name :
           {word, "system." + word, word + ".amplitude", "system.dry_" + word, "first-" + word}) {
        EXPECT_NE(unsupported_feature_message(name).find(subject), std::string::npos) << name;
      }
    }
  }
  EXPECT_EQ(unsupported_feature_message("system.colour"), "");
  EXPECT_EQ(unsupported_feature_message("solve"), "");
}

// No key of the program is reported as unsupported.
TEST(UnsupportedFeature, MatchesNoKeyOfTheProgram) {
  for (const base::DescriptionBase* section : case_section_descriptions()) {
    for (const auto& parameter : section->parameters()) {
      EXPECT_EQ(unsupported_feature_message(section->prefix() + parameter.name), "")
          << parameter.name;
    }
  }
}

TEST(UnsupportedFeature, IsListedInTheReadme) {
  std::ifstream in(FPKCHECK_README);
  const std::string readme(std::istreambuf_iterator<char>(in), {});
  const auto begin = readme.find("## Unsupported problems");
  ASSERT_NE(begin, std::string::npos);
  const std::string section = readme.substr(begin, readme.find("\n## ", begin + 1) - begin);
  for (const auto& [subject, words] : unsupported_features()) {
    EXPECT_NE(section.find(subject), std::string::npos) << subject;
  }
}

}  // namespace
}  // namespace fpkcheck::problem
