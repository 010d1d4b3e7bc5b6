#include "base/files/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <system_error>

namespace fpkcheck::base {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kPartialMarker = ".partial-";

[[noreturn]] void throw_system_error() { throw std::system_error(errno, std::generic_category()); }

int checked_descriptor(int number) {
  if (number < 0) throw_system_error();
  return number;
}

void write_all(const FileDescriptor& file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = write(file.descriptor_number(), bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw_system_error();
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
}

// Flushes a file or directory to disk. The errors EINVAL and ENOTSUP are ignored, since some file
// systems do not support fsync of directories.
void flush_to_disk(const FileDescriptor& file) {
  if (fsync(file.descriptor_number()) != 0 && errno != EINVAL && errno != ENOTSUP)
    throw_system_error();
}

std::string host_name() {
  std::array<char, 256> name{};
  if (gethostname(name.data(), name.size() - 1) != 0) return "unknown";
  std::string host(name.data());
  for (char& c : host) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  }
  constexpr std::size_t kMaxHostLength = 32;  // file systems limit the length of file names
  return host.substr(0, kMaxHostLength);
}

std::string partial_suffix(const std::string& host) {
  return fmt::format("{}{}-", kPartialMarker, host);
}

// Returns the process id in the name of a partial file of this host; 0 for any other file name.
long partial_writer_pid(const std::string& name) {
  const std::string suffix = partial_suffix(WriterProcess::current_process().host);
  const auto at = name.rfind(suffix);
  if (!name.starts_with('.') || at == std::string::npos) return 0;
  const char* const end = name.data() + name.size();
  long pid = 0;
  const auto [stop, error] = std::from_chars(name.data() + at + suffix.size(), end, pid);
  return error == std::errc{} && stop == end && pid > 0 ? pid : 0;
}

}  // namespace

FileDescriptor::~FileDescriptor() {
  if (number_ >= 0) close(number_);
}

bool FileDescriptor::is_regular_file() const {
  struct stat status = {};
  return number_ >= 0 && fstat(number_, &status) == 0 && S_ISREG(status.st_mode);
}

WriterProcess WriterProcess::current_process() {
  static const std::string host = host_name();
  return {host, getpid()};
}

bool WriterProcess::may_be_running() const {
  if (host != current_process().host) return true;
  return kill(static_cast<pid_t>(pid), 0) == 0 || errno != ESRCH;
}

fs::path partial_file_path(const fs::path& target) {
  const auto [host, pid] = WriterProcess::current_process();
  return target.parent_path() /
         fmt::format(".{}{}{}", target.filename().string(), partial_suffix(host), pid);
}

void remove_abandoned_partial_files(const fs::path& directory) {
  for (const auto& entry : fs::directory_iterator(directory)) {
    const long pid = partial_writer_pid(entry.path().filename().string());
    if (pid == 0 || WriterProcess{WriterProcess::current_process().host, pid}.may_be_running())
      continue;
    std::error_code ignored;
    if (fs::is_regular_file(entry.symlink_status(ignored))) fs::remove(entry.path(), ignored);
  }
}

void write_new_file(const fs::path& file, std::string_view bytes) {
  // O_NOFOLLOW prevents a symbolic link of another user from redirecting the output to another
  // file.
  FileDescriptor out(checked_descriptor(
      open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, kFileMode)));
  try {
    write_all(out, bytes);
    flush_to_disk(out);
    // The result of close() is checked, since some systems report a full disk only in close().
    if (close(out.release_descriptor()) != 0 && errno != EINTR) throw_system_error();
  } catch (const std::system_error&) {
    std::error_code ignored;
    fs::remove(file, ignored);
    throw;
  }
}

void flush_to_disk(const fs::path& path) {
  flush_to_disk(FileDescriptor(
      checked_descriptor(open(path.empty() ? "." : path.c_str(), O_RDONLY | O_CLOEXEC))));
}

}  // namespace fpkcheck::base
