#include "methods/external/number_table.hpp"

#include <fmt/format.h>

#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/trim.hpp>

#include <algorithm>
#include <cmath>
#include <locale>
#include <optional>

#include "base/input_error.hpp"
#include "base/text/parse_number.hpp"
#include "base/text/printable_text.hpp"

namespace fpkcheck::methods {
namespace {

std::string trim_blanks(const std::string& text) {
  return boost::algorithm::trim_copy_if(text, boost::algorithm::is_any_of(" \t\r\""));
}

constexpr std::size_t kMaxRows = 100000, kMaxGridRows = 1000000;
constexpr std::size_t kMaxLineLength = 10000;

char separator_of(const std::string& line) {
  for (const char candidate : {';', '\t', ','}) {
    if (line.find(candidate) != std::string::npos) return candidate;
  }
  return ' ';
}

std::string_view name_of_separator(char separator) {
  return separator == ';'    ? "semicolons"
         : separator == '\t' ? "tabs"
         : separator == ','  ? "commas"
                             : "blanks";
}

// Splits a line into fields. Blanks separate fields only if the line has no other separator.
// Successive blanks count as one separator.
std::vector<std::string> split_fields(const std::string& line) {
  const char separator = separator_of(line);
  std::vector<std::string> fields(1);
  for (const char c : line) {
    if (c != separator) {
      fields.back() += c;
    } else if (separator != ' ' || !fields.back().empty()) {
      fields.emplace_back();
    }
  }
  for (auto& field : fields) field = trim_blanks(field);
  return fields;
}

// Removes the unit from a column name: "velocity [m/s]" becomes "velocity", and "v (m/s)" becomes
// "v". The brackets in "p(y)" contain no unit.
std::string remove_units(const std::string& line) {
  std::string kept;
  for (std::size_t k = 0; k < line.size(); ++k) {
    const bool blank_before = kept.empty() || kept.back() == ' ' || kept.back() == '\t';
    const char closing = line[k] == '[' ? ']' : line[k] == '(' && blank_before ? ')' : '\0';
    const auto end = closing != '\0' ? line.find(closing, k) : std::string::npos;
    if (end == std::string::npos) {
      kept += line[k];
    } else {
      k = end;
    }
  }
  return kept;
}

std::optional<double> number(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  return base::parse_number<double>(text);
}

std::vector<std::string> to_lower_case(std::vector<std::string> names) {
  for (auto& name : names) boost::algorithm::to_lower(name, std::locale::classic());
  return names;
}

}  // namespace

std::vector<double> NumberTable::column_values(std::size_t c) const {
  std::vector<double> values;
  for (const auto& row : rows) values.push_back(row[c]);
  return values;
}

void NumberTable::throw_row_error(std::size_t row, const std::string& problem) const {
  throw InputError(fmt::format("{}:{}: {}", base::to_printable_text(source), lines[row], problem));
}

NumberTable read_number_table(std::istream& in, const std::string& source,
                              NumberTableContent content) {
  const bool has_samples = content == NumberTableContent::samples;
  const std::size_t min_columns = has_samples ? 1 : 2;
  const std::string_view accepted_columns = has_samples ? "one to three" : "two or three";
  NumberTable table{source, {}, {}, {}};
  std::vector<std::string> comment;
  int line_number = 0;
  const auto throw_row_error = [&](const std::string& problem) {
    throw InputError(
        fmt::format("{}:{}: {}", base::to_printable_text(source), line_number, problem));
  };
  char first_separator = '\0';
  std::size_t max_rows = kMaxRows;
  for (std::string line; std::getline(in, line);) {
    ++line_number;
    if (line.size() > kMaxLineLength) {
      throw_row_error(
          fmt::format("a line of {} bytes (must be at most {})", line.size(), kMaxLineLength));
    }
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (line_number == 1 && line.starts_with(kByteOrderMark)) line.erase(0, kByteOrderMark.size());
    line = trim_blanks(line);
    if (line.empty()) continue;
    if (line.front() == '#') {
      if (table.rows.empty()) comment = split_fields(trim_blanks(remove_units(line.substr(1))));
      continue;
    }
    const char separator = separator_of(line);
    const auto fields = split_fields(line);
    if (table.rows.empty() && table.names.empty() &&
        std::ranges::none_of(fields, [](const auto& field) { return number(field).has_value(); })) {
      table.names = to_lower_case(split_fields(trim_blanks(remove_units(line))));
      continue;
    }
    std::vector<double> row;
    for (const auto& field : fields) {
      const auto value = number(field);
      if (!value)
        throw_row_error(
            fmt::format("{} is not a number; use a decimal point", base::in_quotes(field)));
      if (!std::isfinite(*value))
        throw_row_error(fmt::format("{} (numbers must be finite)", base::to_printable_text(field)));
      row.push_back(*value);
    }
    if (table.rows.empty()) first_separator = separator;
    if (separator != first_separator) {
      throw_row_error(fmt::format("fields separated by {} after rows with {}; use one separator",
                                  name_of_separator(separator),
                                  name_of_separator(first_separator)));
    }
    const std::size_t columns = table.rows.empty() ? row.size() : table.column_count();
    if (columns < min_columns || columns > 3) {
      throw_row_error(fmt::format("{} column{} (must be {})", columns, columns == 1 ? "" : "s",
                                  accepted_columns));
    }
    if (row.size() != columns) {
      throw_row_error(
          fmt::format("{} columns after rows of {} (must be equal)", row.size(), columns));
    }
    if (table.rows.empty()) {
      const auto names = to_lower_case(table.names.empty() ? comment : table.names);
      const bool is_joint = velocity_column_index(names) < names.size();
      max_rows = is_joint || has_samples ? kMaxGridRows : kMaxRows;
    }
    if (table.rows.size() == max_rows) {
      throw_row_error(fmt::format("more than {} rows; give {}", max_rows,
                                  has_samples ? "fewer samples" : "a coarser density"));
    }
    table.rows.push_back(std::move(row));
    table.lines.push_back(line_number);
  }
  if (table.rows.empty()) {
    throw InputError(fmt::format("{}: no numbers (must be {} columns)",
                                 base::to_printable_text(source), accepted_columns));
  }
  if (table.names.empty() && comment.size() == table.column_count())
    table.names = to_lower_case(comment);
  if (!table.names.empty() && table.names.size() != table.column_count()) {
    table.throw_row_error(0, fmt::format("{} columns under {} names (must be equal)",
                                         table.column_count(), table.names.size()));
  }
  return table;
}

}  // namespace fpkcheck::methods
