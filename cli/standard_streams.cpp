#include "cli/standard_streams.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>

#include "base/text/sanitise.hpp"

namespace fpkcheck::cli {

void prepare_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    // open() returns the lowest free descriptor: `stream`, since the lower ones are open by now.
    if (fcntl(stream, F_GETFD) == -1 && open("/dev/null", O_RDWR) != stream) std::abort();
  }
  std::signal(SIGPIPE, SIG_IGN);
}

void print_output(std::string_view text) {
  std::fwrite(text.data(), 1, text.size(), stdout);
  std::fflush(stdout);
}

void print_message(std::string_view message) {
  const std::string line = fmt::format("fpkcheck: {}\n", base::to_single_line(message));
  std::fwrite(line.data(), 1, line.size(), stderr);
}

}  // namespace fpkcheck::cli
