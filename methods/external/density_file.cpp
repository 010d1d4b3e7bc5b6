#include "methods/external/density_file.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <utility>

#include "base/files/input_file.hpp"
#include "base/input_error.hpp"
#include "base/text/sanitise.hpp"
#include "results/netcdf/reader.hpp"

namespace fpkcheck::methods {

DensityFileContent read_density_file(const std::filesystem::path& file) {
  constexpr std::size_t kMaxBytes = std::size_t{256} << 20, kMaxTextBytes = std::size_t{32} << 20;
  auto bytes = base::read_input_file(file, kMaxBytes);
  if (!bytes) {
    throw InputError(fmt::format("{} is not a readable file; give a file with a density",
                                 base::in_quotes(file.string())));
  }
  if (bytes->starts_with(results::kNetCdfMagic))
    return {DensityFileFormat::netcdf, *std::move(bytes)};
  const std::string name = base::sanitise(file.string());
  if (bytes->starts_with("CDF")) {
    throw InputError(fmt::format(
        "{} has the classic netCDF format; convert it to netCDF-4 by nccopy -k nc4", name));
  }
  if (bytes->find('\0') != std::string::npos) {
    throw InputError(fmt::format("{} is binary (must be columns of text, JSON or netCDF-4)", name));
  }
  if (bytes->size() > kMaxTextBytes) {
    throw InputError(
        fmt::format("{} has more than {} bytes; give a coarser density", name, kMaxTextBytes));
  }
  const auto first = bytes->find_first_not_of(" \t\r\n");
  const bool json =
      first != std::string::npos && (bytes->at(first) == '{' || bytes->at(first) == '[');
  return {json ? DensityFileFormat::json : DensityFileFormat::text, *std::move(bytes)};
}

}  // namespace fpkcheck::methods
