# Packages of cpack: fpkcheck_VERSION_ARCH.deb with the program, fpkcheck-dev_VERSION_ARCH.deb with the libraries,
# and python3-fpkcheck_VERSION_ARCH.deb if the Python package is built.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME fpkcheck)
set(CPACK_PACKAGE_VENDOR "the fpkcheck authors")
set(CPACK_PACKAGE_CONTACT "the fpkcheck authors <fpkcheck@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGE_DESCRIPTION
    "Stationary probability densities of oscillators between walls under Poisson impulses
and white noise, by exponential-polynomial closures, finite volumes and simulation,
compared with one another in tables, figures and an HTML report.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL program development)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME fpkcheck)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
# gnuplot draws the figures with this font.
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "gnuplot-nox | gnuplot, fonts-dejavu-core")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME fpkcheck-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
# Packages that fpkcheckConfig.cmake finds.
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
    "fpkcheck (= ${PROJECT_VERSION}), libboost-dev, libboost-program-options-dev, libeigen3-dev, libfmt-dev, nlohmann-json3-dev, libsundials-dev, libsuitesparse-dev, libnetcdf-dev, zlib1g-dev")
if(FPKCHECK_PYTHON_PACKAGE)
  list(APPEND CPACK_COMPONENTS_ALL python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-fpkcheck)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
  math(EXPR next_minor "${FPKCHECK_PYTHON_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
      "python3 (>= ${FPKCHECK_PYTHON_MAJOR}.${FPKCHECK_PYTHON_MINOR}), python3 (<< ${FPKCHECK_PYTHON_MAJOR}.${next_minor}), python3-numpy")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "python3-xarray, gnuplot-nox | gnuplot")
endif()
include(CPack)
