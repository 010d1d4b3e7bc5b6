#include "report/text/wrap_text.hpp"

#include <sstream>

namespace fpkcheck::report {

std::string wrap_text(std::string_view text, std::size_t width, std::size_t indent) {
  // The first line keeps the leading spaces of the text.
  const std::size_t first_word = text.find_first_not_of(' ');
  std::string result, line(first_word == std::string_view::npos ? 0 : first_word, ' ');
  bool line_is_empty = true;
  std::istringstream words{std::string(text)};
  for (std::string word; words >> word;) {
    if (!line_is_empty && line.size() + 1 + word.size() > width) {
      result += line + '\n';
      line.assign(indent, ' ');
      line_is_empty = true;
    }
    if (!line_is_empty) line += ' ';
    line += word;
    line_is_empty = false;
  }
  return result + line + '\n';
}

}  // namespace fpkcheck::report
