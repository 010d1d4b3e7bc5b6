#include "base/files/append_only_log.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <filesystem>
#include <fstream>

#include "base/input_error.hpp"
#include "temporary_directory.hpp"

namespace fpkcheck::base {
namespace {

using Lines = std::vector<std::string>;

class LineLogFile : public testing::Test {
 protected:
  Lines lines() const {
    AppendOnlyLog log(file_);
    return log.read_lines();
  }

  tests::TemporaryDirectory directory_;
  const std::filesystem::path file_ = directory_.path() / "log";
};

TEST_F(LineLogFile, GrowsByWholeLines) {
  {
    AppendOnlyLog log(file_);
    EXPECT_TRUE(log.read_lines().empty());
    log.append("one");
    log.append("");
    log.flush_to_disk();
  }
  {
    AppendOnlyLog log(file_);
    EXPECT_EQ(log.read_lines(), (Lines{"one", ""}));
    EXPECT_FALSE(log.has_removed_partial_line());
    log.append("two");
  }
  EXPECT_EQ(tests::contents(file_), "one\n\ntwo\n");
}

TEST_F(LineLogFile, RemovesPartialLastLine) {
  std::ofstream(file_) << "one\ntw";
  AppendOnlyLog log(file_);
  EXPECT_EQ(log.read_lines(), Lines{"one"});
  EXPECT_TRUE(log.has_removed_partial_line());
  log.append("three");
  EXPECT_EQ(tests::contents(file_), "one\nthree\n");
}

TEST_F(LineLogFile, ExcludesSecondWriter) {
  {
    const AppendOnlyLog first(file_);
    EXPECT_THROW(AppendOnlyLog{file_}, InputError);
  }
  EXPECT_NO_THROW(AppendOnlyLog{file_});
}

TEST_F(LineLogFile, RejectsSpecialFiles) {
  const auto pipe = directory_.path() / "pipe", link = directory_.path() / "link";
  mkfifo(pipe.c_str(), 0600);
  std::filesystem::create_symlink(file_, link);
  for (const auto& place : {pipe, link, directory_.path()}) {
    EXPECT_THROW(AppendOnlyLog{place}, InputError) << place;
  }
  EXPECT_THROW(AppendOnlyLog{directory_.path() / "absent" / "log"}, std::runtime_error);
}

// The test simulates a full disk. AppendOnlyLog::append() removes the part of the line that was
// already written.
TEST_F(LineLogFile, IsUnchangedWhenAppendFails) {
  AppendOnlyLog log(file_);
  log.read_lines();
  log.append("one");
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{10, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  EXPECT_THROW(log.append("a line that is longer than that"), std::runtime_error);
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(tests::contents(file_), "one\n");
  log.append("two");
  EXPECT_EQ(tests::contents(file_), "one\ntwo\n");
}

}  // namespace
}  // namespace fpkcheck::base
