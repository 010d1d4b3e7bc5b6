#include "results/library_versions.hpp"

#include <fmt/format.h>
#include <netcdf.h>

#include <nlohmann/json_fwd.hpp>

namespace fpkcheck::results {

std::vector<std::pair<std::string, std::string>> library_versions() {
  // "4.9.0 of Oct 15 2022 22:59:31 $"
  const std::string netcdf = nc_inq_libvers();
  return {{"netCDF", netcdf.substr(0, netcdf.find(' '))},
          {"nlohmann-json", fmt::format("{}.{}.{}", NLOHMANN_JSON_VERSION_MAJOR,
                                        NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH)}};
}

}  // namespace fpkcheck::results
