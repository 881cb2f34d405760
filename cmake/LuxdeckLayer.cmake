# luxdeck_layer(NAME DEPENDS target... [PRIVATE target...])
#
# One static library per folder of the layer table: all .cpp files below the folder, headers included
# as "engine/core/rgb.h" from the top.
function(luxdeck_layer name)
  cmake_parse_arguments(ARG "" "" "DEPENDS;PRIVATE" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/*.cpp")
  add_library(luxdeck_${name} STATIC ${sources})
  add_library(luxdeck::${name} ALIAS luxdeck_${name})
  set_target_properties(luxdeck_${name} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(luxdeck_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/luxdeck>)
  target_link_libraries(luxdeck_${name} PUBLIC ${ARG_DEPENDS} PRIVATE ${ARG_PRIVATE} $<BUILD_INTERFACE:luxdeck_flags>)
  set_property(GLOBAL APPEND PROPERTY LUXDECK_LAYERS luxdeck_${name})
endfunction()

add_library(luxdeck_flags INTERFACE)
target_compile_options(luxdeck_flags INTERFACE -Wall -Wextra -Wshadow -Wno-missing-field-initializers
  $<$<BOOL:${LUXDECK_STRICT}>:-Werror>)
# Results must not depend on the compiler's mood: no fused multiply-add contraction, no fast-math.
target_compile_options(luxdeck_flags INTERFACE -ffp-contract=off)
if(LUXDECK_SANITIZE)
  target_compile_options(luxdeck_flags INTERFACE -fsanitize=${LUXDECK_SANITIZE} -fno-omit-frame-pointer)
  target_link_options(luxdeck_flags INTERFACE -fsanitize=${LUXDECK_SANITIZE})
endif()
if(LUXDECK_COVERAGE)
  target_compile_options(luxdeck_flags INTERFACE --coverage)
  target_link_options(luxdeck_flags INTERFACE --coverage)
endif()
