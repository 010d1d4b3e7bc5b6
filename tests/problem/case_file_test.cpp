#include "problem/case_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include <sstream>

#include "base/input_error.hpp"
#include "problem/impulse_law.hpp"
#include "refusal.hpp"

namespace fpkcheck::problem {
namespace {

Problem read(const std::string& text, const std::vector<std::string>& overrides = {}) {
  std::istringstream ini(text);
  return read_case(ini, "a", "a.ini", overrides);
}

std::string message(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return tests::refusal([&] { read(text, overrides); });
}

const std::string kGood =
    "[system]\ndamping = 0.1 ; c\nstiffness = 2 # k\ncubic = 0.3\nrestitution = 0.9\n"
    "[impulse]\nrate = 4\nlaw = gaussian\nintensity = 0.5\n";

TEST(CaseFile, ReadsEveryKeyAndBothKindsOfComment) {
  const Problem p = read(kGood + "mean = 0.1\n");
  EXPECT_EQ(p.system.damping(), 0.1);
  EXPECT_EQ(p.system.stiffness(), 2.0);
  EXPECT_EQ(p.system.coefficients().cubic, 0.3);
  EXPECT_EQ(p.system.restitution(), 0.9);
  EXPECT_EQ(p.impulses.arrival_rate(), 4.0);
  EXPECT_NEAR(p.impulses.intensity(), 0.5, 1e-15);
  EXPECT_EQ(p.impulses.amplitude_law().moment(1), 0.1);
}

TEST(CaseFile, AcceptsByteOrderMarkAndSpaces) {
  EXPECT_EQ(read("\xEF\xBB\xBF" + kGood).system.stiffness(), 2.0);
  EXPECT_EQ(read(kGood, {"system.cubic= +7 "}).system.coefficients().cubic, 7.0);
  EXPECT_NE(message(kGood, {"system.cubic=1e400"}).find("out of the range"), std::string::npos);
}

TEST(CaseFile, MeanDefaultsToZero) {
  EXPECT_EQ(read(kGood).impulses.amplitude_law().moment(1), 0.0);
}

TEST(CaseFile, OverridesReplaceAndComplete) {
  EXPECT_EQ(read(kGood, {"system.cubic=7", "system.damping=8"}).system.coefficients().cubic, 7.0);
  EXPECT_EQ(read("[system]\n" + kGood.substr(kGood.find("stiffness")), {"system.damping=0.2"})
                .system.damping(),
            0.2);
}

std::string name_of(const std::vector<std::string>& overrides, const std::string& text = kGood) {
  std::istringstream ini(text);
  return read_case(ini, "a", "a.ini", overrides, CaseNamingRule::with_overrides).name;
}

TEST(CaseFile, IsNamedByWhatTheOverridesChange) {
  EXPECT_EQ(name_of({}), "a");
  EXPECT_EQ(name_of({"system.restitution=0.8"}), "a, r = 0.8");
  EXPECT_EQ(name_of({"impulse.law=laplace", "impulse.rate=2", "system.damping=0.2"}),
            "a, c = 0.2, lambda = 2, laplace impulses");
  // An override whose value equals that of the file or the default is not a change, in any notation
  // of the number.
  EXPECT_EQ(name_of({"system.restitution=0.90", "impulse.mean=0"}), "a");
  EXPECT_EQ(name_of({"system.damping=0.2"}, "[system]\n" + kGood.substr(kGood.find("stiffness"))),
            "a, c = 0.2");
  // Names of cases contain all digits of the values.
  EXPECT_EQ(name_of({"system.damping=0.1000000000000001"}), "a, c = 0.1000000000000001");
  EXPECT_EQ(read(kGood, {"system.restitution=0.8"}).name, "a");
}

TEST(CaseFile, IsNamedByNumberOfChangesWhenNameIsTooLong) {
  std::vector<std::string> all;
  for (const char* key : {"system.damping", "system.stiffness", "system.cubic",
                          "system.restitution", "impulse.rate", "impulse.intensity"}) {
    all.push_back(std::string(key) + "=0.12345678901234567");
  }
  EXPECT_EQ(name_of(all), "a, 6 keys changed");
}

TEST(CaseFile, NamesTheKeyTheValueAndTheFileInOneLine) {
  const std::string out_of_range = message(kGood, {"system.restitution=1.5"});
  EXPECT_NE(out_of_range.find("system.restitution = 1.5"), std::string::npos) << out_of_range;
  EXPECT_NE(out_of_range.find("a.ini"), std::string::npos) << out_of_range;
  EXPECT_NE(message(kGood + "colour = red\n").find("unknown key 'impulse.colour'"),
            std::string::npos);
  EXPECT_NE(message("[system]\ndamping = 1\n").find("'system.stiffness' is missing"),
            std::string::npos);
  EXPECT_NE(message(kGood, {"system.cubic=lots"}).find("system.cubic = 'lots'"), std::string::npos);
  EXPECT_NE(message(kGood, {"system.cubic=1.0x"}).find("not a number"), std::string::npos);
  EXPECT_NE(message(kGood, {"system.cubic"}).find("not key=value"), std::string::npos);
  EXPECT_NE(message(kGood, {"cubic=1"}).find("unknown key 'cubic'"), std::string::npos);
  EXPECT_NE(message(kGood + "rate = 5\n").find("given twice"), std::string::npos);
  EXPECT_NE(message("what is this").find("a.ini"), std::string::npos);
}

TEST(CaseFile, NamesTheLine) {
  EXPECT_EQ(
      message(kGood + "\nwhat is this\n").find("case a.ini:11: 'what is this' is not a setting"),
      0u);
  EXPECT_EQ(message("; a\n# b\n[system]\ncolour = red\n").find("case a.ini:4: unknown key"), 0u);
  EXPECT_EQ(message(kGood + "rate = 5\n").find("case a.ini:10: key 'impulse.rate' is given"), 0u);
  const auto changed = [](const std::string& from, const std::string& to) {
    return std::string(kGood).replace(kGood.find(from), from.size(), to);
  };
  EXPECT_EQ(message(changed("cubic = 0.3", "cubic = 0.3.1")).find("case a.ini:4: system.cubic"),
            0u);
  EXPECT_EQ(message(changed("= 0.9", "= 1.9")).find("case a.ini:5: system.restitution = 1.9"), 0u);
  // The message for an override states no line of the file.
  EXPECT_EQ(message(kGood, {"system.cubic=1e31"}).find("case a.ini: system.cubic = 1e+31"), 0u);
}

TEST(CaseFile, RejectsDuplicateOverrides) {
  EXPECT_EQ(message(kGood, {"system.cubic=7", "system.cubic=8"}),
            "--set system.cubic is given twice; keep one");
}

TEST(CaseFile, SanitisesTextInMessages) {
  const std::string much(1000000, 'x');
  for (const auto& bad :
       {message(kGood, {"system.cubic=\x1b[31m" + much}),
        message(kGood, {"\x1b[31m" + much + "=1"}), message(kGood, {"\x1b[31m" + much}),
        message("[system]\ndamping = \x1b[31m" + much), message("[\x1b" + much + "]\nx=1"),
        message("\x1b" + much)}) {
    EXPECT_LT(bad.size(), 450u) << bad;  // the longest message lists all keys
    EXPECT_EQ(bad.find('\x1b'), std::string::npos) << bad;
  }
}

TEST(CaseFile, NoSuchCaseListsTheNamedOnes) {
  try {
    load_case("case9");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("case1, case2, case3, case4"), std::string::npos);
  }
}

// Tables, JSON, netCDF files and figures contain the name of a case, and none of these formats can
// represent every byte.
TEST(CaseFile, RejectsUnprintableFileNames) {
  const auto directory = std::filesystem::path(testing::TempDir());
  const auto refusal = [&](const std::string& stem) -> std::string {
    const auto file = directory / (stem + ".ini");
    std::ofstream(file) << kGood;
    std::string message = "accepted";
    try {
      load_case(file.string());
    } catch (const InputError& error) {
      message = error.what();
    }
    std::filesystem::remove(file);
    return message;
  };
  EXPECT_NE(refusal("a\nb").find("control characters"), std::string::npos);
  EXPECT_NE(refusal("a\xff").find("not UTF-8"), std::string::npos);
  EXPECT_NE(refusal(std::string(150, 'x')).find("has 150 bytes"), std::string::npos);
  EXPECT_EQ(refusal("lab 3, größer <b>"), "accepted");
}

TEST(CaseFile, NamedCasesAreTheTableOfThePaper) {
  ASSERT_EQ(paper_cases().size(), 4u);
  const double cubic[] = {0.1, 0.1, 1.0, 1.0};
  const double intensity[] = {0.1, 1.0, 0.1, 1.0};
  for (int n = 0; n < 4; ++n) {
    const Problem p = load_case(paper_cases()[n].name);
    EXPECT_EQ(p.system.damping(), 0.1);
    EXPECT_EQ(p.system.stiffness(), 1.0);
    EXPECT_EQ(p.system.restitution(), 0.98);
    EXPECT_EQ(p.system.coefficients().cubic, cubic[n]);
    EXPECT_EQ(p.impulses.arrival_rate(), 1.0);
    EXPECT_NEAR(p.impulses.intensity(), intensity[n], 1e-15);
  }
}

// Case 1 is the template of other case files.
TEST(CaseFile, OfCase1NamesEveryLaw) {
  const std::string& text = find_built_in_case("case1")->text;
  for (const auto& law : ImpulseLaw::law_names()) {
    EXPECT_NE(text.find(law), std::string::npos) << law;
  }
}

}  // namespace
}  // namespace fpkcheck::problem
