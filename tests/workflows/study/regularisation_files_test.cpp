#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "made_up_studies.hpp"

namespace fpkcheck::study {
namespace {

TEST(RegularisationFiles, JsonHasNullForMissingValuesAndGrowthRates) {
  const auto found = nlohmann::json::parse(json(tests::made_up_regularisation_study(), "fpkcheck"));
  EXPECT_EQ(found.at("system").at("restitution"), 0.98);
  EXPECT_EQ(found.at("default_length"), 0.4);
  const auto& rows = found.at("rows");
  EXPECT_EQ(rows.at(2).at("growth_rate"), 320.0);
  EXPECT_EQ(rows.at(2).at("symbol_grows"), true);
  EXPECT_TRUE(rows.at(0).at("growth_rate").is_null());
  EXPECT_EQ(rows.at(0).at("next").at("im"), 2.1);
  EXPECT_TRUE(rows.at(7).at("rightmost").is_null());
  EXPECT_TRUE(rows.at(7).at("length").is_null());
  EXPECT_EQ(rows.at(7).at("remark"), "there is none");
}

TEST(RegularisationFiles, CsvHasTheSameColumnsInEveryLine) {
  const std::string text = csv(tests::made_up_regularisation_study());
  EXPECT_EQ(std::ranges::count(text, '\n'), 9);
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    EXPECT_EQ(std::ranges::count(line, ','), 14) << line;
  }
  EXPECT_NE(text.find("\nliteral,0.1,0.1,16,60,352,30,320,0,,,320,4.1,2.3,-0.47\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("\npade,0.2,,16,60,,,,,,,,,,\n"), std::string::npos) << text;
}

}  // namespace
}  // namespace fpkcheck::study
