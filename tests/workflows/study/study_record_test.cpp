#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "made_up_studies.hpp"
#include "paper_cases.hpp"
#include "workflows/study/study_record.hpp"

namespace fpkcheck::study {
namespace {

const std::vector<StudyRecord> kRows{{{"name", std::string("one")},
                                      {"n", transform::value_from_count(7)},
                                      {"at.x", 0.125},
                                      {"none", {}}},
                                     {{"name", std::string("two")}, {"at.x", HUGE_VAL}}};

TEST(StudyRecord, IsALineOfCsvWithEmptyCellsForMissingValues) {
  EXPECT_EQ(records_csv_text(kRows, "name n x=at.x none missing"),
            "name,n,x,none,missing\none,7,0.125,,\ntwo,,,,\n");
}

TEST(StudyRecord, HasQuotesAroundTextsWithSeparatorsInCsv) {
  const std::vector<StudyRecord> rows{{{"case", std::string("a, r = 0.9")}, {"x", 0.5}}};
  EXPECT_EQ(records_csv_text(rows, "case x"), "case,x\n\"a, r = 0.9\",0.5\n");
}

TEST(StudyRecord, IsARowOfATableWithDashesForMissingValues) {
  const std::string text = records_table_text(
      kRows, {{"", "who", "name", ""}, {"", "n", "n", ""}, {"", "x", "at.x", "{:.1e}"}}, 80);
  EXPECT_EQ(text, "who  n        x\none  7  1.2e-01\ntwo  -        -\n");
}

TEST(StudyRecord, MissingNumbersAreADash) {
  EXPECT_EQ(number_text(0.125, "{:.2f}"), "0.12");
  EXPECT_EQ(number_text(std::nullopt, "{:.2f}"), "-");
  EXPECT_EQ(number_text(std::nan(""), "{:.2f}"), "-");
}

TEST(StudyRecord, ListsEndWithAnd) {
  EXPECT_EQ(join_with_and({}), "");
  EXPECT_EQ(join_with_and({"2"}), "2");
  EXPECT_EQ(join_with_and({"2", "4", "6"}), "2, 4 and 6");
}

TEST(StudyRecord, ReasonsAreShownForSolutionsThatAreNotOk) {
  const auto who = tests::closure_identity("moment", 4);
  EXPECT_EQ(status_reason_text("it", tests::ok(who, 1), 80), "");
  EXPECT_EQ(status_reason_text("it", tests::not_ok(who, transform::Status::failed), 80),
            "  it failed: it is made up\n");
}

TEST(RecordJson, HasProgramCaseAndRowsByPath) {
  const auto found = nlohmann::json::parse(study_records_to_json(
      "test", tests::make_problem({.restitution = 0.9}), "fpkcheck study test",
      {{"truth.order", transform::value_from_count(5)}, {"truth.reason", std::string()}},
      {{"rows", {{{"at.x", 0.125}, {"at.y", HUGE_VAL}}, {{"at", {}}}}}, {"others", {}}}));
  EXPECT_EQ(found.at("schema"), 1);
  EXPECT_EQ(found.at("program").at("command"), "fpkcheck study test");
  EXPECT_EQ(found.at("study"), "test");
  EXPECT_EQ(found.at("name"), "test");
  EXPECT_EQ(found.at("system").at("restitution"), 0.9);
  EXPECT_EQ(found.at("impulse").at("moments").size(), 7u);
  EXPECT_EQ(found.at("truth").at("order"), 5);
  EXPECT_EQ(found.at("rows").at(0).at("at").at("x"), 0.125);
  EXPECT_TRUE(found.at("rows").at(0).at("at").at("y").is_null());
  EXPECT_TRUE(found.at("rows").at(1).at("at").is_null());
  EXPECT_TRUE(found.at("others").is_array());
}

}  // namespace
}  // namespace fpkcheck::study
