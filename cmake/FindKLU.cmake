# Defines the imported target SuiteSparse::KLU: SuiteSparse before version 6 has no CMake package.
# The target includes CHOLMOD for its nested dissection.
find_path(KLU_INCLUDE_DIR klu.h PATH_SUFFIXES suitesparse)
set(klu_libraries "")
foreach(component IN ITEMS klu cholmod amd colamd btf suitesparseconfig)
  find_library(KLU_${component}_LIBRARY ${component})
  list(APPEND klu_libraries "${KLU_${component}_LIBRARY}")
endforeach()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(
  KLU REQUIRED_VARS KLU_klu_LIBRARY KLU_cholmod_LIBRARY KLU_amd_LIBRARY KLU_colamd_LIBRARY KLU_btf_LIBRARY
                    KLU_suitesparseconfig_LIBRARY KLU_INCLUDE_DIR)
if(KLU_FOUND AND NOT TARGET SuiteSparse::KLU)
  add_library(SuiteSparse::KLU INTERFACE IMPORTED)
  set_target_properties(SuiteSparse::KLU PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${KLU_INCLUDE_DIR}"
                                                    INTERFACE_LINK_LIBRARIES "${klu_libraries}")
endif()
