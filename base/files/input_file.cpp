#include "base/files/input_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>
#include <boost/algorithm/string/trim.hpp>

#include <algorithm>
#include <cerrno>
#include <istream>

#include "base/files/atomic_file.hpp"
#include "base/input_error.hpp"
#include "base/text/printable_text.hpp"

namespace fpkcheck::base {
namespace {

std::string without_comment(std::string line, int line_number) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (line_number == 1 && line.starts_with(kByteOrderMark)) line.erase(0, kByteOrderMark.size());
  return boost::algorithm::trim_copy(line.substr(0, line.find_first_of("#;")));
}

}  // namespace

std::optional<std::string> read_input_file(const std::filesystem::path& file,
                                           std::size_t max_bytes) {
  constexpr std::size_t kChunkBytes = 1 << 20;
  // The flag O_NONBLOCK prevents open() from blocking on a pipe without a writer, since the type of
  // the file is known only after opening.
  const FileDescriptor descriptor(open(file.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
  if (!descriptor.is_regular_file()) return std::nullopt;
  std::string bytes;
  for (;;) {
    // The size of the file is checked while reading, since a file may grow during reading and
    // special files report no size.
    const std::size_t before = bytes.size();
    bytes.resize(before + kChunkBytes);
    const ssize_t count = read(descriptor.descriptor_number(), bytes.data() + before, kChunkBytes);
    bytes.resize(before + static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    if (bytes.size() > max_bytes) {
      throw InputError(
          fmt::format("{} has more than {} bytes: too large for an input file; name another file",
                      to_printable_text(file.string()), max_bytes));
    }
    if (count == 0) return bytes;
    if (count < 0 && errno != EINTR) return std::nullopt;
  }
}

std::vector<IniSetting> read_ini_settings(std::istream& ini, const std::string& where) {
  std::vector<IniSetting> settings;
  std::string section;
  int line_number = 0;
  for (std::string line; std::getline(ini, line);) {
    ++line_number;
    const std::string content = without_comment(line, line_number);
    if (content.empty()) continue;
    const std::string location = fmt::format("{}:{}", where, line_number);
    if (content.front() == '[' && content.back() == ']') {
      section = boost::algorithm::trim_copy(content.substr(1, content.size() - 2));
      continue;
    }
    const auto equals = content.find('=');
    if (equals == std::string::npos) {
      throw InputError(fmt::format("{}: {} is not a setting; write [section] or key = value",
                                   location, in_quotes(content)));
    }
    settings.push_back({section, boost::algorithm::trim_copy(content.substr(0, equals)),
                        boost::algorithm::trim_copy(content.substr(equals + 1)), location});
  }
  return settings;
}

}  // namespace fpkcheck::base
