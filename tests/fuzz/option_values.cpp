// Fuzzer of options as on the command line: a line with a list of methods, "transient" or "bounds",
// then lines NAME=TEXT.
#include <sstream>

#include "backward/bounds/options.hpp"
#include "fd_fpk/options.hpp"
#include "fuzz_helpers.hpp"
#include "methods/builtin_solvers.hpp"

namespace {

using namespace fpkcheck;

struct Setting {
  std::string name, text;
};

template <class Owner>
Owner parse_options(const base::OptionsDescription<Owner>& description,
                    const std::vector<Setting>& settings) {
  Owner owner{};
  for (const auto& [name, text] : settings) {
    if (const auto* parameter = description.find(name)) {
      description.parse(owner, *parameter, text, name);
    }
  }
  return owner;
}

void methods_selected_by_list(const std::string& list, const std::vector<Setting>& settings) {
  static const methods::SolverRegistry registry = methods::builtin_registry();
  base::Values values;
  for (const auto& solver : registry.solvers()) {
    for (const auto& [name, text] : settings) {
      const auto* parameter = solver.option_descriptions->find(name);
      if (parameter != nullptr) values.push_back({name, parse_value(*parameter, text, name)});
    }
  }
  registry.methods_selected_by_list(list, values);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::istringstream lines{std::string(fuzz::as_text(data, size))};
  std::string list;
  std::getline(lines, list);
  std::vector<Setting> settings;
  for (std::string line; std::getline(lines, line);) {
    const auto equals = line.find('=');
    if (equals != line.npos) settings.push_back({line.substr(0, equals), line.substr(equals + 1)});
  }
  return fuzz::catch_input_errors([&] {
    if (list == "transient") {
      fd_fpk::validate({}, parse_options(fd_fpk::transient_option_descriptions(), settings));
    } else if (list == "bounds") {
      backward::require_valid_bounds_options(
          parse_options(backward::bounds_option_descriptions(), settings));
    } else {
      methods_selected_by_list(list, settings);
    }
  });
}
