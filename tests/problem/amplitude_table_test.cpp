#include "problem/amplitude_table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "laws.hpp"
#include "problem/case_file.hpp"
#include "refusal.hpp"
#include "temporary_directory.hpp"

namespace fpkcheck::problem {
namespace {

std::string refusal(const std::string& csv) {
  return tests::refusal([&] { parse_amplitude_csv(csv, "t.csv"); }, "");
}

TEST(AmplitudeTable, ReadsAtomsAndDensities) {
  const auto atoms = parse_amplitude_csv(
      "\xEF\xBB\xBF# made up\namplitude, probability\r\n-1,0.25\r\n\n3, 0.75\n", "t");
  EXPECT_EQ(amplitude_table_literal(atoms), "probability(-1:0.25,3:0.75)");
  EXPECT_EQ(atoms.amplitude_mean(), 2);
  EXPECT_EQ(atoms.amplitude_variance(), 3);
  const auto wedge = parse_amplitude_csv("amplitude,density\n0,2\n1,0", "t");
  EXPECT_EQ(amplitude_table_literal(wedge), "density(0:2,1:0)");
  EXPECT_NEAR(wedge.amplitude_mean(), 1 / 3.0, 1e-15);
  EXPECT_EQ(
      parse_amplitude_csv("amplitude,probability\n-.2,.7\n.1,.1\n.65,.2", "t").amplitude_mean(), 0);
  EXPECT_NEAR(wedge.amplitude_variance(), 1 / 18.0, 1e-15);
}

TEST(AmplitudeTable, RoundTripsAsLiteral) {
  for (const char* text : {tests::kAtoms, tests::kDensity}) {
    const AmplitudeTable table = parse_amplitude_table_literal(text);
    EXPECT_EQ(amplitude_table_literal(table), text);
    EXPECT_EQ(amplitude_table_literal(table.with_negated_amplitudes().with_negated_amplitudes()),
              text);
    EXPECT_NEAR(table.with_negated_amplitudes().amplitude_mean(), -table.amplitude_mean(), 1e-15);
  }
  // A table that was already normalised is not normalised a second time.
  const auto thirds = parse_amplitude_csv("amplitude,probability\n0,.3333\n1,.3333\n2,.3333", "t");
  EXPECT_NEAR(thirds.weight[0], 1 / 3.0, 1e-15);
  EXPECT_EQ(amplitude_table_literal(parse_amplitude_table_literal(amplitude_table_literal(thirds))),
            amplitude_table_literal(thirds));
  EXPECT_EQ(amplitude_table_summary(tests::kAtoms), "4 probabilities from -2 to 1");
}

TEST(AmplitudeTable, NamesTheInvalidLine) {
  const std::string head = "amplitude,probability\n";
  const std::pair<std::string, std::string> wrong[] = {
      {"", "t.csv:1: the table is empty (the first line must be"},
      {"y,p\n0,1\n", "t.csv:1: 'y,p' (the first line must be amplitude,probability or"},
      {head + "0,0.5\nx,0.5\n", "t.csv:3: 'x,0.5': a row must be two finite numbers"},
      {head + "0,0.5\n1\n", "t.csv:3: '1': a row must be"},
      {head + "0,0.5\n1,0.5,0\n", "t.csv:3: '1,0.5,0': a row must be"},
      {head + "0,0.5\n1,nan\n", "t.csv:3: '1,nan': a row must be"},
      {head + "0,0.5\n1e99,0.5\n", "t.csv:3: '1e99,0.5': a row must be"},
      {head + "1,0.5\n1,0.5\n", "t.csv:3: amplitude 1 after 1 (amplitudes must increase)"},
      {head + "0,0.5\n1,0\n2,0.5", "t.csv:3: probability = 0 (must be above 0)"},
      {"amplitude,density\n0,1\n1,-1\n", "t.csv:3: density = -1 (must be 0 or above)"},
      {head + "0,1\n", "t.csv:2: fewer than two rows"},
      {head + "0,0.5\n1,0.4\n", "t.csv:3: the table's probability sums to 0.9 "},
      {head + "0,0.5\n1e-300,0.5\n", "t.csv:3: the table's amplitudes, 0 .. 1e-300"},
      {head + "0,1\n1,1e-300\n", "t.csv:3: the table's amplitudes, 0 .. 1, have"},
      {"amplitude,density\n0,1\n2,1\n", "t.csv:3: the table's density integrates to 2 "},
  };
  for (const auto& [csv, expected] : wrong) {
    const std::string said = refusal(csv);
    EXPECT_TRUE(said.starts_with(expected)) << csv << said;
    EXPECT_EQ(said.find('\n'), std::string::npos);
  }
  std::string long_one = head;
  for (int k = 0; k <= static_cast<int>(kMaxTableRows); ++k)
    long_one += std::to_string(k) + ",0.001\n";
  EXPECT_TRUE(refusal(long_one).starts_with("t.csv:1002: more than 1000 rows"))
      << refusal(long_one);
}

/// A case file with an amplitude table in the same directory.
class TableOfACase : public testing::Test {
 protected:
  void write(const std::string& name, const std::string& text) {
    std::ofstream(directory_.path() / name) << text;
  }
  std::string file(const std::string& name) const { return (directory_.path() / name).string(); }

  tests::TemporaryDirectory directory_;
};

constexpr const char* kSystem =
    "[system]\ndamping = 0.1\nstiffness = 1\nrestitution = 0.9\n[impulse]\nrate = 2\nlaw = tabulated\n";

TEST_F(TableOfACase, IsReadBesideTheFileAndSetsMeanAndIntensity) {
  write("kicks.csv", "amplitude,probability\n-1,0.25\n3,0.75\n");
  write("mine.ini", std::string(kSystem) + "table = kicks.csv\n");
  const Problem p = load_case(file("mine.ini"));
  EXPECT_EQ(p.impulses.amplitude_law().mean(), 2);
  EXPECT_NEAR(p.impulses.intensity(), 2 * 7, 1e-14);
  EXPECT_NEAR(p.impulses.amplitude_law().moment(3), 0.25 * -1 + 0.75 * 27, 1e-13);
  // After the case was loaded, the problem no longer needs the CSV file.
  std::filesystem::remove(file("kicks.csv"));
  const Problem again = problem_from_sections("again", case_file_sections(p));
  EXPECT_EQ(again.impulses.amplitude_law().moments(), p.impulses.amplitude_law().moments());
  ASSERT_EQ(case_file_sections(again).size(), case_file_sections(p).size());
  for (std::size_t k = 0; k < case_file_sections(p).size(); ++k) {
    EXPECT_EQ(case_file_sections(again)[k].values, case_file_sections(p)[k].values);
  }
  EXPECT_EQ(non_default_parameters_text(p).find("0.25"), std::string::npos)
      << non_default_parameters_text(p);
}

TEST_F(TableOfACase, IsShiftedAndScaledToWhatIsGiven) {
  write("kicks.csv", "amplitude,density\n0,2\n1,0\n");
  write("mine.ini", std::string(kSystem) + "table = kicks.csv\nmean = 0\n");
  const Problem shifted = load_case(file("mine.ini"));
  EXPECT_EQ(shifted.impulses.amplitude_law().mean(), 0);
  EXPECT_NEAR(shifted.impulses.amplitude_law().amplitude_standard_deviation(), std::sqrt(1 / 18.0),
              1e-15);
  const Problem scaled =
      load_case(file("mine.ini"), {"impulse.intensity=8"}, CaseNamingRule::with_overrides);
  EXPECT_NEAR(scaled.impulses.amplitude_law().amplitude_standard_deviation(), 2, 1e-15);
  EXPECT_NEAR(scaled.impulses.amplitude_law().skewness(),
              shifted.impulses.amplitude_law().skewness(), 1e-13);
  EXPECT_EQ(scaled.name, "mine, lambda E[Y^2] = 8");
  const Problem other = load_case(file("mine.ini"), {"impulse.table=" + std::string(tests::kAtoms)},
                                  CaseNamingRule::with_overrides);
  EXPECT_TRUE(other.name.starts_with("mine, ")) << other.name;
  EXPECT_NE(other.name.find("another table"), std::string::npos) << other.name;
}

TEST_F(TableOfACase, IsRejectedWithLocation) {
  write("kicks.csv", "amplitude,probability\n-1,0.25\n3,0.65\n");
  write("mine.ini", std::string(kSystem) + "table = kicks.csv\n");
  const auto said = [&](const std::vector<std::string>& overrides) -> std::string {
    return tests::refusal([&] { load_case(file("mine.ini"), overrides); }, "");
  };
  EXPECT_NE(said({}).find("mine.ini:8: "), std::string::npos) << said({});
  EXPECT_NE(said({}).find("kicks.csv:3: the table's probability"), std::string::npos) << said({});
  write("mine.ini", std::string(kSystem) + "table = nowhere.csv\n");
  EXPECT_NE(said({}).find("the file cannot be read"), std::string::npos) << said({});
  write("mine.ini", kSystem);
  EXPECT_NE(said({"impulse.intensity=1"}).find("impulse.table is missing"), std::string::npos);
  const std::string table = std::string("impulse.table=") + tests::kAtoms;
  EXPECT_NE(said({table, "impulse.skewness=1"}).find("impulse.skewness = 1"), std::string::npos);
  EXPECT_NE(said({table, "impulse.law=gaussian", "impulse.intensity=1"}).find("impulse.table"),
            std::string::npos);
}

}  // namespace
}  // namespace fpkcheck::problem
