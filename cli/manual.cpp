#include "cli/manual.hpp"

#include <fmt/format.h>

#include "results/run.hpp"

namespace fpkcheck::cli {
namespace {

// Escapes text for troff: backslashes, hyphens (to be copied as ASCII), and lines that begin like a
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

// Section of the man page with the usage text of a command, whose lines are not refilled.
std::string usage_section(const std::string& usage) {
  constexpr std::size_t kWidth = 72;  // man indents the text by seven columns
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

std::string manual_page(const std::vector<CommandHelp>& commands) {
  const auto program = results::this_program("");
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
