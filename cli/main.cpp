#include <string>
#include <vector>

#include "cli/program.hpp"
#include "cli/shutdown_after_signal.hpp"
#include "cli/terminal.hpp"

int main(int argc, char** argv) {
  using namespace fpkcheck::cli;
  prepare_standard_streams();
  const ShutdownWatchdog watchdog;
  return run_program(std::vector<std::string>(argv + 1, argv + argc));
}
