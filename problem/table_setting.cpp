#include "problem/table_setting.hpp"

#include <fmt/format.h>

#include "base/files/input_file.hpp"
#include "base/input_error.hpp"
#include "base/text/shown.hpp"
#include "problem/amplitude_table.hpp"

namespace fpkcheck::problem {

std::string table_setting(const std::string& said, const std::filesystem::path& folder) {
  constexpr std::size_t kMostBytes = 1 << 17;
  if (is_amplitude_table(said)) return text_of(amplitude_table_of_text(said));
  const std::filesystem::path file = folder / said;
  const auto csv = base::read_input_file(file, kMostBytes);
  if (!csv) {
    throw InputError(
        fmt::format("impulse.table = {}: the file cannot be read; name a CSV file with the columns "
                    "amplitude,probability or amplitude,density",
                    base::in_quotes(file.string())));
  }
  return text_of(amplitude_table_of_csv(*csv, base::shown(file.string())));
}

}  // namespace fpkcheck::problem
