#include "compare/page/solution_columns.hpp"

#include "compare/page/number_text.hpp"

namespace fpkcheck::compare {

using Json = nlohmann::ordered_json;

const Json* value_under(const Json& solution, std::string_view path) {
  const Json* at = &solution;
  while (true) {
    const auto dot = path.find('.');
    const auto found = at->find(path.substr(0, dot));
    if (!at->is_object() || found == at->end() || found->is_null()) return nullptr;
    at = &*found;
    if (dot == std::string_view::npos) return at;
    path.remove_prefix(dot + 1);
  }
}

namespace {

std::optional<double> number_under(const Json& solution, std::string_view path) {
  const Json* value = value_under(solution, path);
  if (value == nullptr || !value->is_number()) return std::nullopt;
  return value->get<double>();
}

}  // namespace

SolutionColumn number_column(const std::string& header, const std::string& path, int digits) {
  return {header,
          [path, digits](const Json& s) { return number_text(number_under(s, path), digits); }};
}

SolutionColumn plain_column(const std::string& header, const std::string& path) {
  return {header, [path](const Json& s) { return plain_text(number_under(s, path)); }};
}

SolutionColumn l1_column(const std::string& header, const std::string& path) {
  return {header, [path](const Json& s) { return l1_cell(number_under(s, path)); }};
}

SolutionColumn word_column(const std::string& header, const std::string& path) {
  return {header,
          [path](const Json& solution) {
            const Json* value = value_under(solution, path);
            const bool is_text = value != nullptr && value->is_string();
            return is_text ? value->get<std::string>() : std::string(kNoValue);
          },
          Align::left};
}

std::string solutions_table(const std::string& caption, const std::vector<const Json*>& solutions,
                            const std::vector<SolutionColumn>& columns) {
  std::vector<HtmlColumn> table{{"solution", Align::left}};
  for (const auto& column : columns) table.push_back({column.header, column.align});
  for (const Json* solution : solutions) {
    table.front().cells.push_back(solution->at("id"));
    for (std::size_t c = 0; c < columns.size(); ++c) {
      table[c + 1].cells.push_back(columns[c].cell(*solution));
    }
  }
  return table_html(caption, std::move(table));
}

}  // namespace fpkcheck::compare
