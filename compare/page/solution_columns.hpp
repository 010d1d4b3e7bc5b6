#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "compare/page/html.hpp"

namespace fpkcheck::compare {

/// A column as a question to a solution.
struct SolutionColumn {
  std::string header;
  std::function<std::string(const nlohmann::ordered_json& solution)> cell;
  Align align = Align::right;
};

/// What a solution has under a path of keys, such as "error.y_l1"; null where there is nothing.
const nlohmann::ordered_json* value_under(const nlohmann::ordered_json& solution,
                                          std::string_view path);

/// A column of the number under a path of keys.
SolutionColumn number_column(const std::string& header, const std::string& path, int digits);

/// A column of the count, or the given number, under a path of keys.
SolutionColumn plain_column(const std::string& header, const std::string& path);

/// A column of the L1 distance under a path of keys.
SolutionColumn l1_column(const std::string& header, const std::string& path);

/// A column of the text under a path of keys.
SolutionColumn word_column(const std::string& header, const std::string& path);

/// A table with a row for each of these solutions of summary.json, named by their ids.
std::string solutions_table(const std::string& caption,
                            const std::vector<const nlohmann::ordered_json*>& solutions,
                            const std::vector<SolutionColumn>& columns);

}  // namespace fpkcheck::compare
