#include "base/files/atomic_file.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>

#include "temporary_directory.hpp"

namespace fpkcheck::base {
namespace {

namespace fs = std::filesystem;

TEST(WriteNewFile, DoesNotReplaceAFile) {
  const tests::TemporaryDirectory directory;
  write_new_file(directory.path() / "f", "old");
  EXPECT_THROW(write_new_file(directory.path() / "f", "new"), std::system_error);
  EXPECT_EQ(tests::contents(directory.path() / "f"), "old");
}

TEST(WriteNewFile, DoesNotFollowALink) {
  const tests::TemporaryDirectory directory;
  fs::create_symlink(directory.path() / "elsewhere", directory.path() / "f");
  EXPECT_THROW(write_new_file(directory.path() / "f", "text"), std::system_error);
  EXPECT_FALSE(fs::exists(directory.path() / "elsewhere"));
}

// A limit of the file size simulates a full disk: the first bytes are written, and then write()
// fails.
TEST(WriteNewFile, LeavesNoFileWithoutSpace) {
  const tests::TemporaryDirectory directory;
  rlimit before = {};
  getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{4096, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  EXPECT_THROW(write_new_file(directory.path() / "f", std::string(10000, 'x')), std::system_error);
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_TRUE(directory.entries().empty());
}

TEST(WriterProcess, OfAnotherHostMayBeRunning) {
  EXPECT_TRUE(WriterProcess::current_process().may_be_running());
  constexpr long kNobody = 4194999;  // above the largest process id
  EXPECT_FALSE((WriterProcess{WriterProcess::current_process().host, kNobody}.may_be_running()));
  EXPECT_TRUE((WriterProcess{"elsewhere", kNobody}.may_be_running()));
}

}  // namespace
}  // namespace fpkcheck::base
