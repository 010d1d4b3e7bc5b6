#include "base/files/file_transaction.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <functional>

#include "refusal.hpp"
#include "temporary_directory.hpp"

namespace fpkcheck::base {
namespace {

namespace fs = std::filesystem;

TEST(ReplaceFile, WritesTheWholeFileAndNothingElse) {
  const tests::TemporaryDirectory directory;
  write_file_atomically(directory.path() / "f", "old and longer");
  write_file_atomically(directory.path() / "f", "new");
  EXPECT_EQ(tests::contents(directory.path() / "f"), "new");
  EXPECT_EQ(directory.entries(), std::vector<std::string>{"f"});
}

TEST(ReplaceFile, KeepsTheOldFileWhileTheNewOneIsWritten) {
  const tests::TemporaryDirectory directory;
  const fs::path target = directory.path() / "f";
  write_file_atomically(target, "old");
  replace_file_atomically(target, [&](const fs::path& temporary) {
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
  write_file_atomically(target, "old");
  const auto fails = [](const fs::path& temporary) {
    std::ofstream(temporary) << "half";
    throw std::domain_error("stopped");
  };
  EXPECT_THROW(replace_file_atomically(target, fails), std::domain_error);
  EXPECT_EQ(tests::contents(target), "old");
  EXPECT_EQ(directory.entries(), std::vector<std::string>{"f"});
}

TEST(FileTransaction, ReplaceTheirTargetsTogether) {
  const tests::TemporaryDirectory directory;
  for (const char* name : {"a", "b", "c"}) write_file_atomically(directory.path() / name, "old");
  FileTransaction files;
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

TEST(FileTransaction, KeepAllTargetsOnFailure) {
  const tests::TemporaryDirectory directory;
  for (const char* name : {"a", "c"}) write_file_atomically(directory.path() / name, "old");
  fs::create_directories(directory.path() / "taken" / "inside");
  {
    FileTransaction files;
    files.add(directory.path() / "a", "new");
    files.remove(directory.path() / "c");
    files.add(directory.path() / "taken", "new");
    EXPECT_THROW(files.commit(), std::runtime_error);
  }
  {
    FileTransaction files;
    files.add(directory.path() / "a", "new");
    const auto fails = [](const fs::path&) { throw std::domain_error("stopped"); };
    EXPECT_THROW(files.add(directory.path() / "b", fails), std::domain_error);
  }
  EXPECT_EQ(tests::contents(directory.path() / "a"), "old");
  EXPECT_EQ(tests::contents(directory.path() / "c"), "old");
  EXPECT_EQ(directory.entries().size(), 3u);
}

TEST(FileTransaction, RequireOneDirectory) {
  const tests::TemporaryDirectory directory;
  fs::create_directory(directory.path() / "below");
  FileTransaction files;
  files.add(directory.path() / "a", "new");
  EXPECT_THROW(files.add(directory.path() / "below" / "b", "new"), std::logic_error);
}

TEST(ReplaceFile, FailsOnDirectoryOrMissingOutput) {
  const tests::TemporaryDirectory directory;
  fs::create_directories(directory.path() / "taken" / "inside");
  EXPECT_THROW(write_file_atomically(directory.path() / "taken", "text"), std::runtime_error);
  EXPECT_EQ(directory.entries(), std::vector<std::string>{"taken"});
  EXPECT_THROW(replace_file_atomically(directory.path() / "f", [](const fs::path&) {}),
               std::runtime_error);
  EXPECT_THROW(write_file_atomically(directory.path() / "absent" / "f", "text"),
               std::runtime_error);
}

namespace fs = std::filesystem;

// Runs `act` in a child process that exits immediately afterwards, like a process that was killed.
void in_killed_process(const std::function<void()>& act) {
  const pid_t child = fork();
  if (child == 0) {
    act();
    _exit(0);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  ASSERT_EQ(status, 0);
}

class JournalOfKilledRun : public testing::Test {
 protected:
  JournalOfKilledRun() {
    for (const char* name : {"a", "b", "gone"}) write_file_atomically(path(name), "old");
  }

  fs::path path(const char* name) const { return directory.path() / name; }
  std::string text(const char* name) const { return tests::contents(path(name)); }

  // The journal of a run that replaces the files a, b and c and removes the file `gone`.
  FileChangeJournal journal() const {
    FileChangeJournal made;
    for (const char* name : {"a", "b", "c"}) {
      const fs::path partial = partial_file_path(path(name));
      write_new_file(partial, "new");
      made.renames.push_back({partial.filename().string(), name});
    }
    made.removals.push_back("gone");
    return made;
  }
  void expect_the_new_files() const {
    for (const char* name : {"a", "b", "c"}) EXPECT_EQ(text(name), "new") << name;
    EXPECT_EQ(directory.entries().size(), 3u);
  }
  std::string refusal() const {
    return tests::refusal([&] { recover_interrupted_commit(directory.path()); }, "");
  }

  tests::TemporaryDirectory directory;
};

TEST_F(JournalOfKilledRun, IsAppliedByNextRun) {
  in_killed_process([&] { journal().write_to_directory(directory.path()); });
  EXPECT_EQ(text("a"), "old");
  recover_interrupted_commit(directory.path());
  expect_the_new_files();
}

TEST_F(JournalOfKilledRun, IsAppliedAfterPartialChange) {
  in_killed_process([&] {
    const FileChangeJournal all = journal();
    all.write_to_directory(directory.path());
    fs::rename(directory.path() / all.renames[0].from, path("a"));
  });
  EXPECT_EQ(text("a"), "new");
  EXPECT_EQ(text("b"), "old");
  recover_interrupted_commit(directory.path());
  expect_the_new_files();
}

TEST_F(JournalOfKilledRun, UnpublishedChangesNothing) {
  in_killed_process([&] { journal(); });
  recover_interrupted_commit(directory.path());
  for (const char* name : {"a", "b", "gone"}) EXPECT_EQ(text(name), "old") << name;
  remove_abandoned_partial_files(directory.path());
  EXPECT_EQ(directory.entries().size(), 3u);
}

TEST_F(JournalOfKilledRun, IsLeftToRunningProcess) {
  journal().write_to_directory(directory.path());  // written by this process
  const std::string message = refusal();
  EXPECT_NE(message.find("is writing files into"), std::string::npos) << message;
  EXPECT_EQ(text("a"), "old");
  FileChangeJournal other;
  EXPECT_THROW(other.write_to_directory(directory.path()), std::system_error);
}

TEST_F(JournalOfKilledRun, WithPathsElsewhereIsRejected) {
  for (const char* line : {"remove\n../outside\n", "remove\n/etc/passwd\n",
                           "rename\n../outside\na\n", "rename\na\n", "what\n"}) {
    write_file_atomically(path(FileChangeJournal::kFileName),
                          "fpkcheck commit 1\n" + WriterProcess::current_process().host +
                              "\n4194999\n" + line + "end\n");
    EXPECT_NE(refusal().find("is not a journal of this user, or damaged"), std::string::npos)
        << line;
  }
}

TEST_F(JournalOfKilledRun, TruncatedIsRejected) {
  in_killed_process([&] { journal().write_to_directory(directory.path()); });
  const std::string whole = text(FileChangeJournal::kFileName);
  for (std::size_t size = 0; size < whole.size(); size += 7) {
    write_file_atomically(path(FileChangeJournal::kFileName), whole.substr(0, size));
    EXPECT_FALSE(refusal().empty()) << size;
    EXPECT_EQ(text("a"), "old") << size;
  }
}

}  // namespace
}  // namespace fpkcheck::base
