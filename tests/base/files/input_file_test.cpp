#include "base/files/input_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "base/input_error.hpp"
#include "temporary_directory.hpp"

namespace fpkcheck::base {
namespace {

TEST(InputFile, IsReadUpToSizeLimit) {
  const tests::TemporaryDirectory directory;
  const auto file = directory.path() / "file";
  std::ofstream(file, std::ios::binary) << std::string("a\0b", 3);
  EXPECT_EQ(read_input_file(file, 3), std::string("a\0b", 3));
  EXPECT_THROW(read_input_file(file, 2), InputError);
}

TEST(InputFile, RejectsSpecialFiles) {
  const tests::TemporaryDirectory directory;
  const auto pipe = directory.path() / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(read_input_file(pipe, 10), std::nullopt);  // a pipe without a writer
  EXPECT_EQ(read_input_file("/dev/zero", 10), std::nullopt);
  EXPECT_EQ(read_input_file(directory.path(), 10), std::nullopt);
  EXPECT_EQ(read_input_file(directory.path() / "absent", 10), std::nullopt);
}

}  // namespace
}  // namespace fpkcheck::base
