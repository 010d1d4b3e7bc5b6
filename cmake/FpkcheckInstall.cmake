# Installed files (docs/installing.md) in two components: `program`, and `development` with the libraries.
include(CMakePackageConfigHelpers)

get_property(libraries GLOBAL PROPERTY FPKCHECK_LIBRARIES)
get_property(folders GLOBAL PROPERTY FPKCHECK_FOLDERS)

# Refuses the installation unless all files of a component are built. Otherwise CMake would stop at the first
# missing file, with the files before it installed.
function(fpkcheck_require_built component)
  install(
    CODE "set(files \"${ARGN}\")
          foreach(file IN LISTS files)
            if(NOT EXISTS \"\${file}\")
              message(FATAL_ERROR \" fpkcheck is not installed: \${file} is not built; run cmake --build ${PROJECT_BINARY_DIR} first.\")
            endif()
          endforeach()"
    COMPONENT ${component})
endfunction()

set(program_files "$<TARGET_FILE:fpkcheck>")
if(TARGET fpkcheck_manual)
  list(APPEND program_files "${PROJECT_BINARY_DIR}/cli/fpkcheck.1")
endif()
set(library_files "")
foreach(library IN LISTS libraries)
  list(APPEND library_files "$<TARGET_FILE:${library}>")
endforeach()
fpkcheck_require_built(program ${program_files})
fpkcheck_require_built(development ${library_files})

install(TARGETS fpkcheck COMPONENT program)
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${CMAKE_INSTALL_DOCDIR}" COMPONENT program)
install(FILES "${PROJECT_SOURCE_DIR}/third_party/plotly/LICENSE" RENAME LICENSE.plotly
        DESTINATION "${CMAKE_INSTALL_DOCDIR}" COMPONENT program)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/cases" DESTINATION "${CMAKE_INSTALL_DATADIR}/fpkcheck"
        COMPONENT program)
if(TARGET fpkcheck_manual)
  install(FILES "${PROJECT_BINARY_DIR}/cli/fpkcheck.1" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1" COMPONENT program)
endif()
install(FILES "${PROJECT_SOURCE_DIR}/cli/completion.bash" RENAME fpkcheck
        DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions" COMPONENT program)

set(package_directory "${CMAKE_INSTALL_LIBDIR}/cmake/fpkcheck")
install(TARGETS ${libraries} EXPORT fpkcheck COMPONENT development)
install(EXPORT fpkcheck NAMESPACE fpkcheck:: FILE fpkcheckTargets.cmake
        DESTINATION "${package_directory}" COMPONENT development)
configure_package_config_file(
  "${PROJECT_SOURCE_DIR}/cmake/fpkcheckConfig.cmake.in" "${PROJECT_BINARY_DIR}/fpkcheckConfig.cmake"
  INSTALL_DESTINATION "${package_directory}" NO_SET_AND_CHECK_MACRO NO_CHECK_REQUIRED_COMPONENTS_MACRO)
# Before version 1.0, a minor version may change every interface.
write_basic_package_version_file("${PROJECT_BINARY_DIR}/fpkcheckConfigVersion.cmake"
                                 COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/fpkcheckConfig.cmake"
              "${PROJECT_BINARY_DIR}/fpkcheckConfigVersion.cmake"
              "${PROJECT_SOURCE_DIR}/cmake/FindKLU.cmake" "${PROJECT_SOURCE_DIR}/cmake/FindNetCDF.cmake"
        DESTINATION "${package_directory}" COMPONENT development)

# Headers include each other as "epc/solve.hpp"; installed headers as "fpkcheck/epc/solve.hpp", to avoid
# collisions with folders such as `report` or `methods` of other projects.
string(REPLACE ";" "|" any_folder "${folders}")
install(
  CODE "set(folders \"${folders}\")
        set(any_folder \"${any_folder}\")
        set(source \"${PROJECT_SOURCE_DIR}\")
        set(staged \"${PROJECT_BINARY_DIR}/installed-headers\")
        set(destination \"${CMAKE_INSTALL_INCLUDEDIR}\")"
  COMPONENT development)
install(SCRIPT "${PROJECT_SOURCE_DIR}/cmake/InstallHeaders.cmake" COMPONENT development)
