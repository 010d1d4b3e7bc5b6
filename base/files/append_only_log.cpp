#include "base/files/append_only_log.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>
#include <system_error>

#include "base/input_error.hpp"
#include "base/text/printable_text.hpp"

namespace fpkcheck::base {

void AppendOnlyLog::throw_error(const char* what) const {
  throw std::runtime_error(fmt::format("{} cannot be {}: {}",
                                       base::to_printable_text(file_.string()), what,
                                       std::generic_category().message(errno)));
}

AppendOnlyLog::AppendOnlyLog(const std::filesystem::path& file)
    : file_(file),
      // O_NOFOLLOW prevents a symbolic link of another user from redirecting the output to another
      // file. O_NONBLOCK prevents open() from blocking on a pipe.
      descriptor_(open(file.c_str(),
                       O_RDWR | O_APPEND | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC,
                       kFileMode)) {
  if (descriptor_.descriptor_number() < 0 && errno != ELOOP && errno != EISDIR && errno != ENXIO)
    throw_error("opened");
  const bool regular = descriptor_.is_regular_file();
  if (regular && flock(descriptor_.descriptor_number(), LOCK_EX | LOCK_NB) == 0) return;
  throw InputError(
      regular ? fmt::format("{} is locked: another process writes it; wait, or use another "
                            "directory",
                            base::to_printable_text(file_.string()))
              : fmt::format("{} is not a regular file; remove it, or use another directory",
                            base::to_printable_text(file_.string())));
}

std::vector<std::string> AppendOnlyLog::read_lines() {
  constexpr std::size_t kChunkBytes = 1 << 20;
  std::string text;
  std::string buffer(kChunkBytes, '\0');
  for (;;) {
    const ssize_t count = pread(descriptor_.descriptor_number(), buffer.data(), buffer.size(),
                                static_cast<off_t>(text.size()));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw_error("read");
    if (count == 0) break;
    text.append(buffer, 0, static_cast<std::size_t>(count));
  }
  std::vector<std::string> lines;
  std::size_t begin = 0;
  for (auto end = text.find('\n'); end != text.npos; end = text.find('\n', begin)) {
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  removed_partial_line_ = begin < text.size();
  length_ = static_cast<long long>(begin);
  if (removed_partial_line_ && ftruncate(descriptor_.descriptor_number(), length_) != 0)
    throw_error("written");
  return lines;
}

void AppendOnlyLog::append(std::string_view line) {
  const std::string text = std::string(line) + '\n';
  std::string_view rest = text;
  while (!rest.empty()) {
    const ssize_t count = write(descriptor_.descriptor_number(), rest.data(), rest.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) {
      const int why = errno;
      if (ftruncate(descriptor_.descriptor_number(), length_) != 0) errno = why;
      errno = why;
      throw_error("written");
    }
    rest.remove_prefix(static_cast<std::size_t>(count));
  }
  length_ += static_cast<long long>(text.size());
}

void AppendOnlyLog::flush_to_disk() const {
  // The error EINVAL of fdatasync is ignored, since some file systems do not support fdatasync.
  if (fdatasync(descriptor_.descriptor_number()) != 0 && errno != EINVAL && errno != ENOTSUP)
    throw_error("written");
}

}  // namespace fpkcheck::base
