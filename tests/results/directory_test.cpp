#include "results/output_directory.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>

#include "base/files/atomic_file.hpp"
#include "base/files/file_transaction.hpp"
#include "refusal.hpp"
#include "temporary_directory.hpp"

namespace fpkcheck::results {
namespace {

namespace fs = std::filesystem;

std::string refusal_to_write(const fs::path& directory) {
  return tests::refusal([&] { const auto made = prepare_output_directory(directory); });
}

TEST(FileStem, KeepsPortableCharacters) {
  EXPECT_EQ(case_file_stem("it's a-1.x_/"), "it_s_a-1.x__");
  EXPECT_EQ(case_file_stem("case1, r = 0.9"), "case1_r_0.9");
}

TEST(RunDirectory, IsCreatedWithItsParents) {
  const tests::TemporaryDirectory parent;
  const fs::path directory = parent.path() / "a" / "b";
  const auto made = prepare_output_directory(directory);
  EXPECT_TRUE(fs::is_directory(directory));
  EXPECT_FALSE(fs::exists(directory / "figures"));
  { const auto none = prepare_output_directory(directory); }  // a second call creates nothing
  EXPECT_TRUE(fs::is_directory(directory));
}

TEST(RunDirectory, IsRemovedIfEmpty) {
  const tests::TemporaryDirectory parent;
  { const auto made = prepare_output_directory(parent.path() / "a" / "b"); }
  EXPECT_TRUE(parent.entries().empty());
  {
    const auto made = prepare_output_directory(parent.path() / "a" / "b");
    base::write_file_atomically(parent.path() / "a" / "f", "text");
  }
  EXPECT_FALSE(fs::exists(parent.path() / "a" / "b"));
  EXPECT_TRUE(fs::exists(parent.path() / "a" / "f"));
}

// Runs `action` in a child process, which exits with 0 when `action` returns.
template <typename Action>
pid_t run_in_child(const Action& action) {
  const pid_t child = fork();
  if (child != 0) return child;
  try {
    action();
    _exit(0);
  } catch (...) {
    _exit(1);
  }
}

bool has_succeeded(pid_t child) {
  int status = 1;
  return waitpid(child, &status, 0) == child && status == 0;
}

// One of two runs with the same output directory may end, without files, while the other still
// solves.
TEST(RunDirectory, RemainsWhileAnotherRunUsesIt) {
  const tests::TemporaryDirectory parent;
  const fs::path directory = parent.path() / "a" / "b", holds = parent.path() / "holds",
                 first_ended = parent.path() / "first-ended";
  pid_t second = 0;
  {
    const auto made = prepare_output_directory(directory);
    second = run_in_child([&] {
      const auto found = prepare_output_directory(directory);
      base::write_file_atomically(holds, "");
      while (!fs::exists(first_ended)) usleep(1000);
      base::write_file_atomically(directory / "f", "text");
    });
    while (!fs::exists(holds)) usleep(1000);
  }
  base::write_file_atomically(first_ended, "");
  EXPECT_TRUE(has_succeeded(second));
  EXPECT_EQ(tests::contents(directory / "f"), "text");
  EXPECT_EQ(std::distance(fs::directory_iterator(directory), fs::directory_iterator()), 1);
}

TEST(RunDirectory, MayBeCreatedByConcurrentRuns) {
  const tests::TemporaryDirectory parent;
  std::vector<pid_t> runs;
  for (int n = 0; n < 6; ++n) {
    runs.push_back(run_in_child([&] {
      for (int again = 0; again < 200; ++again) {
        const auto made = prepare_output_directory(parent.path() / "a" / "b");
      }
    }));
  }
  for (const pid_t run : runs) EXPECT_TRUE(has_succeeded(run));
}

TEST(RunDirectory, RefusesAnImpossiblePathAndLeavesNothing) {
  const tests::TemporaryDirectory parent;
  const std::string too_long(300, 'x');
  const std::string message = refusal_to_write(parent.path() / "a" / "b" / too_long);
  EXPECT_NE(message.find("cannot write into directory"), std::string::npos) << message;
  EXPECT_NE(message.find("name too long"), std::string::npos) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  EXPECT_TRUE(parent.entries().empty());
}

TEST(RunDirectory, RefusesAnExistingFile) {
  const tests::TemporaryDirectory parent;
  base::write_file_atomically(parent.path() / "file", "text");
  EXPECT_NE(refusal_to_write(parent.path() / "file").find("Not a directory"), std::string::npos);
  EXPECT_NE(refusal_to_write(parent.path() / "file" / "below").find("ot a directory"),
            std::string::npos);
  EXPECT_EQ(tests::contents(parent.path() / "file"), "text");
}

// Files of another program, of an active run, and of an interrupted run.
TEST(RunDirectory, RemovesOnlyFilesOfInterruptedRuns) {
  const tests::TemporaryDirectory directory;
  const std::string own = base::partial_file_path(directory.path() / "f").filename().string();
  const std::string before_pid = own.substr(0, own.rfind('-') + 1);
  constexpr const char* kNobody = "4194999";  // exceeds the largest process id
  const std::vector<std::string> stay{".movie.mkv.partial-download",
                                      ".f.partial-" + std::string(kNobody),
                                      ".f.partial-elsewhere-" + std::string(kNobody),
                                      own,
                                      before_pid.substr(1) + kNobody,
                                      before_pid + "1x"};
  for (const auto& name : stay) std::ofstream(directory.path() / name) << "text";
  std::ofstream(directory.path() / (before_pid + kNobody)) << "text";
  { const auto made = prepare_output_directory(directory.path()); }
  auto left = directory.entries();
  std::ranges::sort(left);
  auto expected = stay;
  std::ranges::sort(expected);
  EXPECT_EQ(left, expected);
}

TEST(RunDirectory, RefusesAnUnwritableDirectory) {
  // Not writable even for the superuser.
  EXPECT_NE(refusal_to_write("/proc/self").find("cannot write into"), std::string::npos);
}

}  // namespace
}  // namespace fpkcheck::results
