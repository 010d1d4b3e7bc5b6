#include "cli/progress_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace fpkcheck::cli {

ProgressLine::ProgressLine(bool silent) : active_(!silent && isatty(STDERR_FILENO) == 1) {}

ProgressLine::~ProgressLine() { clear(); }

void ProgressLine::show(const compare::RunProgress& progress) {
  if (!active_) return;
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin_;
  const std::string part = progress.fraction > 0 && progress.fraction < 1
                               ? fmt::format(" {:3.0f} %", 100 * progress.fraction)
                               : "";
  fmt::print(stderr, "\r\033[K[{}/{}] {:.0f} s  {} {}{}{}{}", progress.done, progress.total,
             elapsed.count(), progress.case_name, progress.method, part,
             progress.note.empty() ? "" : "  ", progress.note);
  std::fflush(stderr);
  shown_ = true;
}

void ProgressLine::clear() {
  if (shown_) fmt::print(stderr, "\r\033[K");
  std::fflush(stderr);
  shown_ = false;
}

}  // namespace fpkcheck::cli
