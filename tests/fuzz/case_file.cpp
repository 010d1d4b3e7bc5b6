// Fuzzer of case files. The lines after a line "--set" are overrides.
#include "problem/case_file.hpp"

#include <sstream>

#include "fuzz_helpers.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace fpkcheck;
  constexpr std::string_view kOverrides = "\n--set\n";
  const std::string_view text = fuzz::as_text(data, size);
  const auto end = text.find(kOverrides);
  std::vector<std::string> overrides;
  if (end != text.npos) {
    std::istringstream lines{std::string(text.substr(end + kOverrides.size()))};
    for (std::string line; std::getline(lines, line);) overrides.push_back(line);
  }
  return fuzz::catch_input_errors([&] {
    std::istringstream ini{std::string(text.substr(0, end))};
    problem::read_case(ini, "fuzz", "fuzz.ini", overrides);
  });
}
