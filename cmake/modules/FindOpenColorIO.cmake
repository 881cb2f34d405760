# Debian's libopencolorio-dev (2.1) puts its CMake config into /usr/share/cmake, where CMake does not look and
# from where its relative paths are wrong. This defines the same target, OpenColorIO::OpenColorIO.
find_package(OpenColorIO CONFIG QUIET)
if(TARGET OpenColorIO::OpenColorIO)
  return()
endif()

find_path(OpenColorIO_INCLUDE_DIR OpenColorIO/OpenColorIO.h)
find_library(OpenColorIO_LIBRARY OpenColorIO)
mark_as_advanced(OpenColorIO_INCLUDE_DIR OpenColorIO_LIBRARY)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(OpenColorIO REQUIRED_VARS OpenColorIO_LIBRARY OpenColorIO_INCLUDE_DIR)
if(OpenColorIO_FOUND)
  add_library(OpenColorIO::OpenColorIO UNKNOWN IMPORTED)
  set_target_properties(OpenColorIO::OpenColorIO PROPERTIES
    IMPORTED_LOCATION "${OpenColorIO_LIBRARY}" INTERFACE_INCLUDE_DIRECTORIES "${OpenColorIO_INCLUDE_DIR}")
endif()
