#include "base/files/pending_files.hpp"

#include <gtest/gtest.h>

#include "temporary_directory.hpp"

namespace fpkcheck::base {
namespace {

namespace fs = std::filesystem;

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
    // rename() works within one file system only
    EXPECT_EQ(temporary.parent_path(), target.parent_path());
  });
  EXPECT_EQ(tests::contents(target), "new");
}

TEST(ReplaceFile, KeepsTargetOnFailure) {
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

TEST(PendingFiles, KeepAllTargetsOnFailure) {
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
    const auto fails = [](const fs::path&) { throw std::domain_error("stopped"); };
    EXPECT_THROW(files.add(directory.path() / "b", fails), std::domain_error);
  }
  EXPECT_EQ(tests::contents(directory.path() / "a"), "old");
  EXPECT_EQ(tests::contents(directory.path() / "c"), "old");
  EXPECT_EQ(directory.entries().size(), 3u);
}

TEST(PendingFiles, RequireOneDirectory) {
  const tests::TemporaryDirectory directory;
  fs::create_directory(directory.path() / "below");
  PendingFiles files;
  files.add(directory.path() / "a", "new");
  EXPECT_THROW(files.add(directory.path() / "below" / "b", "new"), std::logic_error);
}

TEST(ReplaceFile, FailsOnDirectoryOrMissingOutput) {
  const tests::TemporaryDirectory directory;
  fs::create_directories(directory.path() / "taken" / "inside");
  EXPECT_THROW(write_file(directory.path() / "taken", "text"), std::runtime_error);
  EXPECT_EQ(directory.entries(), std::vector<std::string>{"taken"});
  EXPECT_THROW(replace_file(directory.path() / "f", [](const fs::path&) {}), std::runtime_error);
  EXPECT_THROW(write_file(directory.path() / "absent" / "f", "text"), std::runtime_error);
}

}  // namespace
}  // namespace fpkcheck::base
