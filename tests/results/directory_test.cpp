#include "results/directory.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "files/pending_files.hpp"
#include "files/whole_file.hpp"
#include "parameters/input_error.hpp"
#include "temporary_directory.hpp"

namespace fpkcheck::results {
namespace {

namespace fs = std::filesystem;

std::string refusal_to_write(const fs::path& directory) {
  try {
    const auto made = make_writable(directory);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(FileStem, KeepsWhatEveryFileSystemTakes) {
  EXPECT_EQ(file_stem("it's a-1.x_/"), "it_s_a-1.x__");
  EXPECT_EQ(file_stem("case1, r = 0.9"), "case1_r_0.9");
}

TEST(RunDirectory, IsMadeWithItsParentsAndLeftEmpty) {
  const tests::TemporaryDirectory parent;
  const fs::path directory = parent.path() / "a" / "b";
  const auto made = make_writable(directory);
  EXPECT_TRUE(fs::is_directory(directory));
  EXPECT_TRUE(fs::is_empty(directory));
  { const auto none = make_writable(directory); }  // again is fine, and makes nothing
  EXPECT_TRUE(fs::is_directory(directory));
}

TEST(RunDirectory, GoesAgainWhenNothingIsPutIntoIt) {
  const tests::TemporaryDirectory parent;
  { const auto made = make_writable(parent.path() / "a" / "b"); }
  EXPECT_TRUE(parent.entries().empty());
  {
    const auto made = make_writable(parent.path() / "a" / "b");
    files::write_file(parent.path() / "a" / "f", "text");
  }
  EXPECT_FALSE(fs::exists(parent.path() / "a" / "b"));
  EXPECT_TRUE(fs::exists(parent.path() / "a" / "f"));
}

TEST(RunDirectory, ThatCannotBeIsRefusedInOneLineAndNothingIsLeft) {
  const tests::TemporaryDirectory parent;
  const std::string too_long(300, 'x');
  const std::string message = refusal_to_write(parent.path() / "a" / "b" / too_long);
  EXPECT_NE(message.find("cannot write into directory"), std::string::npos) << message;
  EXPECT_NE(message.find("name too long"), std::string::npos) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  EXPECT_TRUE(parent.entries().empty());
}

TEST(RunDirectory, WhereAFileStandsIsRefused) {
  const tests::TemporaryDirectory parent;
  files::write_file(parent.path() / "file", "text");
  EXPECT_NE(refusal_to_write(parent.path() / "file").find("Not a directory"), std::string::npos);
  EXPECT_NE(refusal_to_write(parent.path() / "file" / "below").find("ot a directory"),
            std::string::npos);
  EXPECT_EQ(tests::contents(parent.path() / "file"), "text");
}

// Of somebody else, of a run that is at work, and of one that was stopped.
TEST(RunDirectory, LosesOnlyWhatAStoppedRunLeft) {
  const tests::TemporaryDirectory directory;
  const std::string own = files::partial_beside(directory.path() / "f").filename().string();
  const std::string before_pid = own.substr(0, own.rfind('-') + 1);
  constexpr const char* kNobody = "4194999";  // beyond the greatest number of a process
  const std::vector<std::string> stay{".movie.mkv.partial-download",
                                      ".f.partial-" + std::string(kNobody),
                                      ".f.partial-elsewhere-" + std::string(kNobody),
                                      own,
                                      before_pid.substr(1) + kNobody,
                                      before_pid + "1x"};
  for (const auto& name : stay) std::ofstream(directory.path() / name) << "text";
  std::ofstream(directory.path() / (before_pid + kNobody)) << "text";
  { const auto made = make_writable(directory.path()); }
  auto left = directory.entries();
  std::ranges::sort(left);
  auto expected = stay;
  std::ranges::sort(expected);
  EXPECT_EQ(left, expected);
}

TEST(RunDirectory, ThatIsNotWritableIsRefused) {
  // Holds for the superuser too.
  EXPECT_NE(refusal_to_write("/proc/self").find("cannot write into"), std::string::npos);
}

}  // namespace
}  // namespace fpkcheck::results
