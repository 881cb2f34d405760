# What `cmake --install` and the packages hold: component Runtime is the program with its sample projects,
# component Development the libraries and headers for find_package(luxdeck).
include(CMakePackageConfigHelpers)

set(config_folder "${CMAKE_INSTALL_LIBDIR}/cmake/luxdeck")
get_property(layers GLOBAL PROPERTY LUXDECK_LAYERS)

if(TARGET luxdeck)
  install(TARGETS luxdeck RUNTIME COMPONENT Runtime)
endif()
install(DIRECTORY projects/ DESTINATION "${CMAKE_INSTALL_DATADIR}/luxdeck/projects" COMPONENT Runtime)
install(FILES LICENSE README.md DESTINATION "${CMAKE_INSTALL_DOCDIR}" COMPONENT Runtime)
if(TARGET luxdeck_man)
  install(FILES "${PROJECT_BINARY_DIR}/luxdeck.1" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1" COMPONENT Runtime)
endif()
if(TARGET luxdeck_completions)
  # Where Debian's bash-completion, zsh and fish look for what packages bring.
  set(completions "${PROJECT_BINARY_DIR}/completions")
  install(FILES "${completions}/luxdeck" DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions" COMPONENT Runtime)
  install(FILES "${completions}/_luxdeck" DESTINATION "${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions" COMPONENT Runtime)
  install(FILES "${completions}/luxdeck.fish" DESTINATION "${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d" COMPONENT Runtime)
endif()
install(DIRECTORY docs/schemas DESTINATION "${CMAKE_INSTALL_DATADIR}/luxdeck" COMPONENT Runtime)

install(TARGETS ${layers} EXPORT luxdeckTargets ARCHIVE COMPONENT Development)
install(DIRECTORY engine tonemap analysis DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/luxdeck" COMPONENT Development
  FILES_MATCHING PATTERN "*.h")
install(EXPORT luxdeckTargets NAMESPACE luxdeck:: DESTINATION "${config_folder}" COMPONENT Development)
install(DIRECTORY cmake/modules DESTINATION "${config_folder}" COMPONENT Development)
configure_package_config_file(cmake/luxdeckConfig.cmake.in "${PROJECT_BINARY_DIR}/luxdeckConfig.cmake"
  INSTALL_DESTINATION "${config_folder}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/luxdeckConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/luxdeckConfig.cmake" "${PROJECT_BINARY_DIR}/luxdeckConfigVersion.cmake"
  DESTINATION "${config_folder}" COMPONENT Development)

set(CPACK_GENERATOR DEB TGZ)
set(CPACK_PACKAGE_NAME luxdeck)
set(CPACK_PACKAGE_VENDOR "The Luxdeck authors")
set(CPACK_PACKAGE_CONTACT "The Luxdeck authors <luxdeck@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGE_DESCRIPTION "Computes the light in a room from its geometry, luminaires and sky, with an interval for\
 every number, and writes illuminance tables, pictures in cd/m2 and PDF reports.")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL Runtime Development)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_ARCHIVE_COMPONENT_INSTALL OFF)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME luxdeck)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_RECOMMENDS "fonts-inter, fonts-dejavu-core")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME luxdeck-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
string(CONCAT CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libembree-dev, libtbb-dev, libfmt-dev, libimath-dev, "
  "libopenexr-dev, libopencolorio-dev, libpng-dev, libjpeg-dev, libtomlplusplus-dev, nlohmann-json3-dev, "
  "libxxhash-dev, qtbase5-dev, libqt5svg5-dev")
include(CPack)
