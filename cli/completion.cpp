#include "cli/help.hpp"

#include <algorithm>
#include <set>

#include "base/input_error.hpp"
#include "problem/case_file.hpp"
#include "problem/excitation.hpp"
#include "problem/system.hpp"
#include "workflows/study/closure_order_study.hpp"

namespace fpkcheck::cli {
namespace {

using Words = std::vector<std::string>;

Words method_names(const methods::SolverRegistry& registry) {
  Words names;
  std::set<std::string> seen;
  const auto add = [&](const std::string& name) {
    if (seen.insert(name).second) names.push_back(name);
  };
  for (const auto& solver : registry.solvers()) {
    add(solver.name);
    for (const auto& family : solver.families) {
      add(family.name);
      for (const auto& id : family.default_ids) add(id);
    }
  }
  return names;
}

// Returns the keys of case files as completion candidates, including the named constants of the
// case on the command line.
Words case_key_candidates(const Words& words) {
  Words keys;
  for (const auto* section : problem::case_section_descriptions()) {
    for (const auto& parameter : section->parameters()) {
      keys.push_back(section->prefix() + parameter.name + '=');
    }
  }
  for (const auto& word : words) {
    if (problem::find_built_in_case(word) == nullptr && !word.ends_with(".ini")) continue;
    try {
      const problem::Problem loaded =
          problem::load_case(word, {}, problem::CaseNamingRule::from_file,
                             problem::CaseFileTimeSectionPolicy::allowed);
      for (const auto& [name, value] : loaded.system.named_constants()) {
        keys.push_back("parameters." + name + '=');
      }
    } catch (const InputError&) {
      // An unfinished case file has no named constants yet.
    }
  }
  return keys;
}

// Returns the allowed values of a command-line option. For a command such as `run`, which is no
// solver, the option values of all solvers are returned.
Words option_choices(const std::string& flag, const std::string& command,
                     const methods::SolverRegistry& registry) {
  Words choices;
  const auto* const own = registry.find_solver(command);
  for (const auto& solver : registry.solvers()) {
    if (own != nullptr && own != &solver) continue;
    for (const auto& parameter : solver.option_descriptions->parameters()) {
      if ("--" + parameter.flag != flag) continue;
      for (const auto& choice : parameter.choices) {
        if (std::ranges::find(choices, choice) == choices.end()) choices.push_back(choice);
      }
    }
  }
  return choices;
}

Words prepend_earlier_list_items(const std::string& word, Words items) {
  const auto comma = word.rfind(',');
  if (comma == std::string::npos) return items;
  for (auto& item : items) item = word.substr(0, comma + 1) + item;
  return items;
}

Words option_values(const OptionHelp& option, const Words& words, const CommandHelp& command,
                    const methods::SolverRegistry& registry) {
  const auto& word = words.back();
  if (option.name == "--methods") return prepend_earlier_list_items(word, method_names(registry));
  if (option.name == "--formulations")
    return prepend_earlier_list_items(word, study::closure_formulations(registry));
  if (option.name == "--set") return case_key_candidates(words);
  if (option.placeholder.starts_with("FILE")) return {kFileNamesCandidate};
  if (option.placeholder == "DIR") return {kDirectoryNamesCandidate};
  return option_choices(option.name, command.name, registry);
}

// Returns completion candidates for the positional arguments, which the first line of the help of a
// command names.
Words positional_candidates(const CommandHelp& command) {
  const auto first_line = command.help.usage.substr(0, command.help.usage.find('\n'));
  const auto takes = [&](const char* what) { return first_line.find(what) != std::string::npos; };
  if (takes("SUBJECT")) return {};
  if (takes("DIR")) return {kDirectoryNamesCandidate};
  if (!takes("CASE")) return {kFileNamesCandidate};
  Words cases;
  for (const auto* list : {&problem::paper_cases(), &problem::example_oscillator_cases()}) {
    for (const auto& named : *list) cases.push_back(named.name);
  }
  cases.emplace_back(kFileNamesCandidate);
  return cases;
}

Words words_with_prefix(const std::string& start, const Words& all) {
  Words chosen;
  for (const auto& word : all) {
    if (word.starts_with(start) || word.starts_with(':')) chosen.push_back(word);
  }
  return chosen;
}

const CommandHelp* find_command(const std::vector<CommandHelp>& commands, const std::string& name) {
  const auto found = std::ranges::find(commands, name, &CommandHelp::name);
  return found == commands.end() ? nullptr : &*found;
}

// Returns the words after the text `before` in the names of commands, e.g. "grid" after "study ".
Words words_after_prefix(const std::vector<CommandHelp>& commands, const std::string& before) {
  Words names;
  for (const auto& command : commands) {
    if (!command.name.starts_with(before)) continue;
    const auto rest = command.name.substr(before.size());
    if (!rest.empty() && rest.find(' ') == std::string::npos) names.push_back(rest);
  }
  return names;
}

}  // namespace

Words completion_candidates(const std::vector<CommandHelp>& commands,
                            const methods::SolverRegistry& registry, const Words& words) {
  if (words.empty()) return {};
  const auto& word = words.back();
  const bool is_help = words.front() == "help" && words.size() > 1;
  const std::size_t first = is_help ? 1 : 0;
  if (words.size() == first + 1) {
    auto names = words_after_prefix(commands, "");
    if (!is_help) names.insert(names.end(), {"help", "--help", "--version"});
    return words_with_prefix(word, names);
  }
  const auto subjects = words_after_prefix(commands, words[first] + ' ');
  if (words.size() == first + 2 && !subjects.empty()) return words_with_prefix(word, subjects);
  if (is_help) return {};
  const auto* command = find_command(commands, words[0]);
  if (!subjects.empty()) command = find_command(commands, words[0] + ' ' + words[1]);
  if (command == nullptr) return {};

  const auto& options = command->help.options;
  const auto before = std::ranges::find(options, words[words.size() - 2], &OptionHelp::name);
  if (before != options.end() && !before->placeholder.empty()) {
    return words_with_prefix(word, option_values(*before, words, *command, registry));
  }
  if (!word.starts_with('-')) return words_with_prefix(word, positional_candidates(*command));
  Words names;
  for (const auto& option : options) names.push_back(option.name);
  return words_with_prefix(word, names);
}

}  // namespace fpkcheck::cli
