#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "made_up_studies.hpp"
#include "workflows/study/kramers_moyal_regularisation_study.hpp"

namespace fpkcheck::study {
namespace {

TEST(RegularisationStudy, HasTheGrowthOfEachRow) {
  const auto study = tests::made_up_regularisation_study();
  EXPECT_FALSE(study.rows[0].growth_rate);
  EXPECT_FALSE(study.rows[0].symbol_grows);
  EXPECT_EQ(study.rows[2].growth_rate, 320.0);
  EXPECT_TRUE(study.rows[2].symbol_grows);
  EXPECT_FALSE(study.rows[7].growth_rate);
}

TEST(RegularisationStudy, HasConvergedIfTheDefaultLengthHasADensityOnTheFinestStep) {
  auto study = tests::made_up_regularisation_study();
  EXPECT_TRUE(has_converged(study));
  study.rows[6].growth_rate = 1;
  EXPECT_FALSE(has_converged(study));
  study = tests::made_up_regularisation_study();
  study.rows[6].l1_y.reset();
  EXPECT_FALSE(has_converged(study));
  study.rows.clear();
  EXPECT_FALSE(has_converged(study));
}

TEST(RegularisationFiles, JsonHasNullForMissingValuesAndGrowthRates) {
  const auto found =
      nlohmann::json::parse(study_json_text(tests::made_up_regularisation_study(), "fpkcheck"));
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
  const std::string text = study_csv_text(tests::made_up_regularisation_study());
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

TEST(RegularisationTable, ReportsWhichSchemesGrowAndWhichDecay) {
  const std::string text =
      tests::in_one_line(study_table_text(tests::made_up_regularisation_study(), 100));
  for (const char* expected :
       {"literal 0.1 0.1 16x60 352 30 320 - x10 in 0.0072 4.10000 2.30000 -5e-01",
        "literal 0.4 0.4 16x60 0 - -1e-15 -0.119+-2.1i settles 0.00030 0.00040 -1e-07",
        "pade 0.2 - 16x60 - - - - - - - -", "pade at h = 0.2: there is none",
        "grows at h = 0.2 and 0.1, in the end as h^-4.00", "up to L1 2.3 from kf",
        "falls to -0.47 of its peak", "default length l = 0.4 grows on no step",
        "L1 0.0003 in p(y) and 0.0004 in p(y')", "threshold is l* = 0.3",
        "10 % below it the matrices of h = 0.1 grow", "10 % above it no matrix grows"}) {
    EXPECT_NE(text.find(expected), std::string::npos) << expected << "\n" << text;
  }
}

TEST(RegularisationTable, FitsItsWidth) {
  for (const std::size_t width : {80u, 100u}) {
    EXPECT_LE(tests::longest_line(study_table_text(tests::made_up_regularisation_study(), width)),
              width);
  }
}

}  // namespace
}  // namespace fpkcheck::study
