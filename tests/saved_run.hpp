#pragma once

#include <cstdlib>
#include <string>

#include "made_up_solutions.hpp"
#include "results/run.hpp"

/// A synthetic run for tests of saved runs and their reports.
namespace fpkcheck::tests {

inline results::Run made_up_run(const std::string& name = "case1") {
  return {results::current_program("fpkcheck run"), {made_up_case(name)}};
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

inline bool gnuplot_exists() { return std::system("command -v gnuplot >/dev/null 2>&1") == 0; }

}  // namespace fpkcheck::tests
