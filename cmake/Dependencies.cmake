list(APPEND CMAKE_MODULE_PATH "${CMAKE_CURRENT_LIST_DIR}/modules")

find_package(Threads REQUIRED)
find_package(TBB REQUIRED)
find_package(fmt REQUIRED)
# Quiet: Debian's Imath config mentions a Python binding that is not installed with it.
find_package(Imath QUIET REQUIRED)
find_package(OpenEXR REQUIRED)
find_package(PNG REQUIRED)
find_package(JPEG REQUIRED)
# Debian installs OpenColorIO's CMake files where they compute a wrong prefix ("/include"): find it by hand.
find_path(OPENCOLORIO_INCLUDE_DIR OpenColorIO/OpenColorIO.h REQUIRED)
find_library(OPENCOLORIO_LIBRARY OpenColorIO REQUIRED)
add_library(OpenColorIO::OpenColorIO UNKNOWN IMPORTED)
set_target_properties(OpenColorIO::OpenColorIO PROPERTIES
  IMPORTED_LOCATION "${OPENCOLORIO_LIBRARY}" INTERFACE_INCLUDE_DIRECTORIES "${OPENCOLORIO_INCLUDE_DIR}")
find_package(CLI11 REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(xxhash REQUIRED)
set(XXHASH_LIBRARY xxhash::xxhash)

# Debian 12 has Embree 3, Debian 13 has Embree 4: one source serves both (engine/raycast).
find_package(embree 4 QUIET)
if(NOT embree_FOUND)
  find_package(embree 3 REQUIRED)
endif()
message(STATUS "Embree ${embree_VERSION}")

if(LUXDECK_REPORT)
  find_package(Qt5 REQUIRED COMPONENTS Gui Svg)
endif()

if(LUXDECK_GUI)
  if(NOT LUXDECK_REPORT)
    message(FATAL_ERROR "LUXDECK_GUI needs LUXDECK_REPORT: the program previews and writes reports")
  endif()
  find_package(Qt5 REQUIRED COMPONENTS Widgets)
  # Quiet: VTK's own find modules talk about what it was built with.
  find_package(VTK 9.1 QUIET REQUIRED COMPONENTS
    CommonCore CommonDataModel CommonTransforms FiltersCore FiltersGeneral FiltersModeling FiltersSources GUISupportQt
    ImagingCore InteractionStyle InteractionWidgets IOImage RenderingAnnotation RenderingContextOpenGL2 RenderingCore RenderingFreeType
    RenderingOpenGL2 RenderingUI)
  if(NOT VTK_QT_VERSION EQUAL 5)
    message(FATAL_ERROR "VTK was built with Qt ${VTK_QT_VERSION}, expected 5: the program has to use the same Qt")
  endif()
endif()
