# The CMake package that netCDF-C ships wants the development files of all that it was built with;
# this needs its own header and library only. Makes the imported target netCDF::netcdf.
find_path(NetCDF_INCLUDE_DIR netcdf.h)
find_library(NetCDF_LIBRARY netcdf)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(NetCDF REQUIRED_VARS NetCDF_LIBRARY NetCDF_INCLUDE_DIR)
if(NetCDF_FOUND AND NOT TARGET netCDF::netcdf)
  add_library(netCDF::netcdf UNKNOWN IMPORTED)
  set_target_properties(netCDF::netcdf PROPERTIES IMPORTED_LOCATION "${NetCDF_LIBRARY}"
                                                  INTERFACE_INCLUDE_DIRECTORIES
                                                  "${NetCDF_INCLUDE_DIR}")
endif()
