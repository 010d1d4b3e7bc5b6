#include "base/files/input_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

#include "base/input_error.hpp"
#include "base/text/sanitise.hpp"

namespace fpkcheck::base {
namespace {

/// Owner of a file descriptor: the destructor closes the descriptor.
class Descriptor {
 public:
  // O_NONBLOCK: without this flag, opening a pipe that has no writer would block. Pipes cannot be
  // excluded before, as the type of the file is known only after opening.
  explicit Descriptor(const std::filesystem::path& file)
      : number_(open(file.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC)) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number_ >= 0) close(number_);
  }

  bool is_regular() const {
    struct stat status = {};
    return number_ >= 0 && fstat(number_, &status) == 0 && S_ISREG(status.st_mode);
  }
  int number() const { return number_; }

 private:
  int number_;
};

}  // namespace

std::optional<std::string> read_input_file(const std::filesystem::path& file,
                                           std::size_t max_bytes) {
  constexpr std::size_t kChunkBytes = 1 << 20;
  const Descriptor descriptor(file);
  if (!descriptor.is_regular()) return std::nullopt;
  std::string bytes;
  for (;;) {
    // The bytes are counted while reading, since a file may grow during reading and special files
    // report no size.
    const std::size_t before = bytes.size();
    bytes.resize(before + kChunkBytes);
    const ssize_t count = read(descriptor.number(), bytes.data() + before, kChunkBytes);
    bytes.resize(before + static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    if (bytes.size() > max_bytes) {
      throw InputError(
          fmt::format("{} has more than {} bytes: too large for an input file; name another file",
                      sanitise(file.string()), max_bytes));
    }
    if (count == 0) return bytes;
    if (count < 0 && errno != EINTR) return std::nullopt;
  }
}

}  // namespace fpkcheck::base
