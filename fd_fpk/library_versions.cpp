#include "fd_fpk/library_versions.hpp"

#include <fmt/format.h>
#include <klu.h>
#include <sundials/sundials_version.h>

#include <Spectra/Util/Version.h>
#include <Eigen/Core>

namespace fpkcheck::fd_fpk {

std::vector<std::pair<std::string, std::string>> library_versions() {
  char sundials[32] = "unknown";
  SUNDIALSGetVersion(sundials, sizeof sundials);
  int suitesparse[3] = {};
  SuiteSparse_version(suitesparse);
  return {{"SUNDIALS", sundials},
          {"SuiteSparse", fmt::format("{}.{}.{}", suitesparse[0], suitesparse[1], suitesparse[2])},
          {"KLU", fmt::format("{}.{}.{}", KLU_MAIN_VERSION, KLU_SUB_VERSION, KLU_SUBSUB_VERSION)},
          {"Eigen",
           fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
          {"Spectra", fmt::format("{}.{}.{}", SPECTRA_MAJOR_VERSION, SPECTRA_MINOR_VERSION,
                                  SPECTRA_PATCH_VERSION)}};
}

}  // namespace fpkcheck::fd_fpk
