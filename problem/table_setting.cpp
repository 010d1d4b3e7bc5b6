#include "problem/table_setting.hpp"

#include <fmt/format.h>

#include "base/files/input_file.hpp"
#include "base/input_error.hpp"
#include "base/text/sanitise.hpp"
#include "problem/amplitude_table.hpp"

namespace fpkcheck::problem {

std::string table_literal_from_setting(const std::string& setting,
                                       const std::filesystem::path& folder) {
  constexpr std::size_t kMostBytes = 1 << 17;
  if (is_amplitude_table_literal(setting))
    return amplitude_table_literal(parse_amplitude_table_literal(setting));
  const std::filesystem::path file = folder / setting;
  const auto csv = base::read_input_file(file, kMostBytes);
  if (!csv) {
    throw InputError(
        fmt::format("impulse.table = {}: the file cannot be read; name a CSV file with the columns "
                    "amplitude,probability or amplitude,density",
                    base::in_quotes(file.string())));
  }
  return amplitude_table_literal(parse_amplitude_csv(*csv, base::sanitise(file.string())));
}

}  // namespace fpkcheck::problem
