#include "cli/help.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <sstream>

#include "cli/terminal.hpp"
#include "report/text/text_layout.hpp"
#include "results/run.hpp"

namespace fpkcheck::cli {
namespace {

namespace po = boost::program_options;

// Destination of a command's help text during capture_help(); null if print_or_capture_help()
// prints the help.
thread_local CommandHelpText* captured_help = nullptr;

std::size_t indentation(const std::string& line) {
  return std::min(line.find_first_not_of(' '), line.size());
}

// Returns the column in which the second part (the explanation) of a help line " name text" begins.
// For a help line without a gap of two blanks the column of the explanation is 0.
std::size_t text_column(const std::string& line) {
  const auto gap = line.find("  ", indentation(line));
  return gap == std::string::npos ? 0 : std::min(line.find_first_not_of(' ', gap), line.size());
}

// Usage texts are wrapped at about 96 columns. A line break in a usage text is intended if the
// first word of the next line would fit into the line before.
bool keeps_line_break(const std::string& line, const std::string& next) {
  constexpr std::size_t kFilledWidth = 84;
  const auto begin = indentation(next);
  const auto word = std::min(next.find(' ', begin), next.size()) - begin;
  return line.size() + 1 + word <= kFilledWidth;
}

// Wraps a long example command by backslashes, which shells accept, and moves the remark after the
// command to a separate line.
std::string wrap_example(const std::string& line, std::size_t remark, std::size_t width) {
  constexpr std::size_t kIndent = 6;
  std::string result =
      report::wrap_text(remark > 0 ? line.substr(0, remark) : line, width - 2, kIndent);
  result.pop_back();
  for (auto end = result.find('\n'); end != std::string::npos; end = result.find('\n', end + 3)) {
    result.insert(end, " \\");
  }
  result += '\n';
  if (remark > 0) {
    result += report::wrap_text(std::string(kIndent, ' ') + line.substr(remark), width, kIndent);
  }
  return result;
}

std::string wrap_block(const std::vector<std::string>& lines, std::size_t width) {
  const auto too_long = [&](const auto& line) { return line.size() > width; };
  std::string result;
  if (std::ranges::none_of(lines, too_long)) {
    for (const auto& line : lines) result += line + '\n';
    return result;
  }
  const std::size_t column = text_column(lines.front());
  if (lines.front().starts_with("  fpkcheck ")) return wrap_example(lines.front(), column, width);
  const std::size_t indent = column > 0 ? column : indentation(lines.front());
  for (std::size_t i = 0; i < lines.size();) {
    std::string text = lines[i];
    for (++i; i < lines.size() && !keeps_line_break(lines[i - 1], lines[i]); ++i) {
      text += ' ' + lines[i];
    }
    std::string head;  // first part of the line, whose trailing blanks wrap_text() would remove
    if (column > 0) {
      head = text.substr(0, column);
      text.replace(0, column, column, ' ');
    }
    auto block = report::wrap_text(text, width, indent);
    block.replace(0, head.size(), head);
    result += block;
  }
  return result;
}

std::string option_label(const OptionHelp& option) {
  std::string text = option.short_name.empty() ? "" : option.short_name + ", ";
  text += option.name;
  if (!option.placeholder.empty()) text += ' ' + option.placeholder;
  if (!option.default_value.empty()) text += " (=" + option.default_value + ')';
  return text;
}

OptionHelp option_help(const po::option_description& option) {
  using po::command_line_style::allow_dash_for_short;
  using po::command_line_style::allow_long;
  OptionHelp help{.name = option.canonical_display_name(allow_long),
                  .short_name = option.canonical_display_name(allow_dash_for_short),
                  .text = option.description()};
  // For an option without a short name, Boost returns the long name instead of the short name.
  if (help.short_name.size() != 2 || help.short_name[0] != '-') help.short_name.clear();
  const std::string parameter = option.format_parameter();
  const auto default_begin = parameter.find(" (=");
  help.placeholder = parameter.substr(0, default_begin);
  if (default_begin != std::string::npos) {
    help.default_value = parameter.substr(default_begin + 3, parameter.size() - default_begin - 4);
  }
  return help;
}

// Returns text for troff, with escaped backslashes, hyphens, and lines that begin like a troff
// request.
std::string escape_troff(const std::string& text) {
  std::string result;
  bool line_begins = true;
  for (const char c : text) {
    if (line_begins && (c == '.' || c == '\'')) result += "\\&";
    if (c == '\\') {
      result += "\\e";
    } else if (c == '-') {
      result += "\\-";
    } else {
      result += c;
    }
    line_begins = c == '\n';
  }
  return result;
}

std::string usage_section(const std::string& usage) {
  constexpr std::size_t kWidth = 72;  // man(1) indents the text by seven columns
  return ".nf\n" + escape_troff(wrap_usage(usage, kWidth)) + ".fi\n";
}

std::string option_entry(const OptionHelp& option) {
  std::string text = ".TP\n";
  if (!option.short_name.empty()) text += "\\fB" + escape_troff(option.short_name) + "\\fR, ";
  text += "\\fB" + escape_troff(option.name) + "\\fR";
  if (!option.placeholder.empty()) text += " \\fI" + escape_troff(option.placeholder) + "\\fR";
  if (!option.default_value.empty()) text += " (=" + escape_troff(option.default_value) + ')';
  return text + '\n' + escape_troff(option.text) + '\n';
}

}  // namespace

std::string wrap_usage(const std::string& usage, std::size_t width) {
  std::string result;
  std::vector<std::string> block;
  const auto append_wrapped_block = [&] {
    result += wrap_block(block, width);
    block.clear();
  };
  std::istringstream lines(usage);
  for (std::string line; std::getline(lines, line);) {
    const bool continues =
        !block.empty() && !line.empty() && line != block.front() &&
        indentation(line) == (indentation(block.front()) == 0 ? 0 : text_column(block.front())) &&
        !block.front().starts_with("usage:");
    if (!continues) append_wrapped_block();
    block.push_back(line);
  }
  append_wrapped_block();
  return result;
}

std::string help_text(const CommandHelpText& help, std::size_t width) {
  std::string text = wrap_usage(help.usage, width);
  if (help.options.empty()) return text;
  constexpr std::size_t kIndent = 2, kGap = 2, kMaxLabelWidth = 26;
  std::size_t longest = 0;
  for (const auto& option : help.options) {
    const auto size = option_label(option).size();
    if (size <= kMaxLabelWidth) longest = std::max(longest, size);
  }
  const std::size_t column = kIndent + longest + kGap;
  text += "\noptions:\n";
  for (const auto& option : help.options) {
    std::string line = std::string(kIndent, ' ') + option_label(option);
    if (line.size() + kGap > column) {
      text += line + '\n';
      line.clear();
    }
    line.resize(column, ' ');
    auto block = report::wrap_text(std::string(column, ' ') + option.text, width, column);
    block.replace(0, column, line);
    text += block;
  }
  return text;
}

void print_or_capture_help(const std::string& usage, const po::options_description& options) {
  CommandHelpText help{usage, {}};
  for (const auto& option : options.options()) help.options.push_back(option_help(*option));
  if (captured_help != nullptr) {
    *captured_help = std::move(help);
    return;
  }
  constexpr std::size_t kDefaultWidth = 80;
  std::cout << help_text(help,
                         isatty(STDOUT_FILENO) == 1 ? terminal_format().width : kDefaultWidth);
}

CommandHelpText capture_help(const std::function<void()>& call) {
  CommandHelpText help;
  captured_help = &help;
  try {
    call();
  } catch (...) {
    captured_help = nullptr;
    throw;
  }
  captured_help = nullptr;
  return help;
}

std::string manual_page(const std::vector<CommandHelp>& commands) {
  const auto program = results::current_program("");
  std::string page = fmt::format(".TH FPKCHECK 1 \"\" \"{} {}\" \"User Commands\"\n", program.name,
                                 program.version);
  page += R"(.SH NAME
fpkcheck \- stationary density of an oscillator with or without impacts, under impulses or noise
.SH SYNOPSIS
.B fpkcheck
.I COMMAND
[\fICASE\fR ...] [\fIoptions\fR]
.SH DESCRIPTION
A particle on a hardening spring impacts a wall at its equilibrium position and is excited by random
impulses:
.PP
.nf
    y'' + c y' + k y + mu y^3 = impulses  (y > 0)
    y'(+) = \-r y'(\-)                      at y = 0
.fi
.PP
This is the oscillator of the paper. Other oscillators have a restoring force of fifth degree,
damping that depends on y and y', walls at other positions or none, and white noise with or without
impulses: bistable, gap, van_der_pol, ...
The program computes the stationary probability densities of y and y' by independent methods, which
share only the problem, and compares them.
A CASE is case1 .. case4 (Table 1 of the paper), the name of another oscillator, or an ini file such
as cases/case1.ini.
.SH COMMANDS
)";
  for (const auto& command : commands) {
    page += ".SS " + escape_troff("fpkcheck " + command.name) + '\n';
    if (!command.summary.empty()) page += escape_troff(command.summary) + "\n.PP\n";
    page += usage_section(command.help.usage);
    if (command.help.options.empty()) continue;
    page += ".PP\nOptions:\n";
    for (const auto& option : command.help.options) page += option_entry(option);
  }
  page += R"(.SH EXIT STATUS
.TP
0
success
.TP
1
a solver failed or did not reach the requested accuracy, or a check failed
.TP
2
bad input, with a message of one line
.TP
130
interrupted by SIGINT (Ctrl\-C)
.TP
143
terminated by SIGTERM
.SH ENVIRONMENT
.TP
NO_COLOR
no colours on a terminal, if set to a value that is not empty
)";
  return page;
}

}  // namespace fpkcheck::cli
