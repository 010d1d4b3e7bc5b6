#include "cli/version.hpp"

#include <fmt/format.h>

#include <boost/version.hpp>

#include "fd_fpk/library_versions.hpp"
#include "results/library_versions.hpp"
#include "results/run.hpp"

namespace fpkcheck::cli {

std::string version_text() {
  auto libraries = fd_fpk::library_versions();
  for (auto& library : results::library_versions()) libraries.push_back(std::move(library));
  libraries.emplace_back("Boost", fmt::format("{}.{}.{}", BOOST_VERSION / 100000,
                                              BOOST_VERSION / 100 % 1000, BOOST_VERSION % 100));
  libraries.emplace_back("fmt", fmt::format("{}.{}.{}", FMT_VERSION / 10000,
                                            FMT_VERSION / 100 % 100, FMT_VERSION % 100));
  const auto program = results::this_program("");
  std::string text = fmt::format("{} {}\n", program.name, program.version);
  for (const auto& [name, version] : libraries) text += fmt::format("  {:<14}{}\n", name, version);
  return text;
}

}  // namespace fpkcheck::cli
