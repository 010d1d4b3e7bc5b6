#include "results/directory.hpp"

#include <gtest/gtest.h>

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
    write_file(parent.path() / "a" / "f", "text");
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
  write_file(parent.path() / "file", "text");
  EXPECT_NE(refusal_to_write(parent.path() / "file").find("Not a directory"), std::string::npos);
  EXPECT_NE(refusal_to_write(parent.path() / "file" / "below").find("ot a directory"),
            std::string::npos);
  EXPECT_EQ(tests::contents(parent.path() / "file"), "text");
}

TEST(RunDirectory, ThatIsNotWritableIsRefused) {
  // Holds for the superuser too.
  EXPECT_NE(refusal_to_write("/proc/self").find("cannot write into"), std::string::npos);
}

TEST(ReplaceFile, WritesTheWholeFileAndNothingElse) {
  const tests::TemporaryDirectory directory;
  write_file(directory.path() / "f", "old and longer");
  write_file(directory.path() / "f", "new");
  EXPECT_EQ(tests::contents(directory.path() / "f"), "new");
  EXPECT_EQ(directory.entries(), std::vector<std::string>{"f"});
}

TEST(ReplaceFile, KeepsTheOldFileWhileTheNewOneIsWritten) {
  const tests::TemporaryDirectory directory;
  const fs::path target = directory.path() / "f";
  write_file(target, "old");
  replace_file(target, [&](const fs::path& temporary) {
    std::ofstream(temporary) << "new";
    EXPECT_EQ(tests::contents(target), "old");
    EXPECT_EQ(temporary.parent_path(), target.parent_path());  // a rename cannot cross disks
  });
  EXPECT_EQ(tests::contents(target), "new");
}

TEST(ReplaceFile, ThatFailsLeavesTheTargetAndNoHalfFile) {
  const tests::TemporaryDirectory directory;
  const fs::path target = directory.path() / "f";
  write_file(target, "old");
  const auto fails = [](const fs::path& temporary) {
    std::ofstream(temporary) << "half";
    throw std::domain_error("stopped");
  };
  EXPECT_THROW(replace_file(target, fails), std::domain_error);
  EXPECT_EQ(tests::contents(target), "old");
  EXPECT_EQ(directory.entries(), std::vector<std::string>{"f"});
}

TEST(PendingFiles, ReplaceTheirTargetsTogether) {
  const tests::TemporaryDirectory directory;
  for (const char* name : {"a", "b", "c"}) write_file(directory.path() / name, "old");
  PendingFiles files;
  files.add(directory.path() / "a", "new");
  files.remove(directory.path() / "c");
  files.add(directory.path() / "b", "new");
  EXPECT_EQ(tests::contents(directory.path() / "a"), "old");
  EXPECT_EQ(tests::contents(directory.path() / "c"), "old");
  files.commit();
  EXPECT_EQ(tests::contents(directory.path() / "a"), "new");
  EXPECT_EQ(tests::contents(directory.path() / "b"), "new");
  EXPECT_EQ(directory.entries().size(), 2u);
}

TEST(PendingFiles, OfWhichOneFailsLeaveAllAsTheyWere) {
  const tests::TemporaryDirectory directory;
  for (const char* name : {"a", "c"}) write_file(directory.path() / name, "old");
  fs::create_directories(directory.path() / "taken" / "inside");
  {
    PendingFiles files;
    files.add(directory.path() / "a", "new");
    files.remove(directory.path() / "c");
    files.add(directory.path() / "taken", "new");
    EXPECT_THROW(files.commit(), std::runtime_error);
  }
  {
    PendingFiles files;
    files.add(directory.path() / "a", "new");
    EXPECT_THROW(files.add(directory.path() / "absent" / "b", "new"), std::runtime_error);
  }
  EXPECT_EQ(tests::contents(directory.path() / "a"), "old");
  EXPECT_EQ(tests::contents(directory.path() / "c"), "old");
  EXPECT_EQ(directory.entries().size(), 3u);
}

TEST(ReplaceFile, OfADirectoryOrByNothingIsAnError) {
  const tests::TemporaryDirectory directory;
  fs::create_directories(directory.path() / "taken" / "inside");
  EXPECT_THROW(write_file(directory.path() / "taken", "text"), std::runtime_error);
  EXPECT_EQ(directory.entries(), std::vector<std::string>{"taken"});
  EXPECT_THROW(replace_file(directory.path() / "f", [](const fs::path&) {}), std::runtime_error);
  EXPECT_THROW(write_file(directory.path() / "absent" / "f", "text"), std::runtime_error);
}

}  // namespace
}  // namespace fpkcheck::results
