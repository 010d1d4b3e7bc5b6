# Defines the imported target netCDF::netcdf from the header and the library alone. The CMake package of
# netCDF-C requires the development files of all its dependencies.
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
