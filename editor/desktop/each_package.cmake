# Read by cpack once for each kind of package.
if(CPACK_GENERATOR STREQUAL "TGZ" AND CPACK_ARCHIVE_WITHOUT_PYTHON)
  list(TRANSFORM CPACK_INSTALL_CMAKE_PROJECTS REPLACE "^ALL$" "Unspecified")
endif()
# Without these cpack would make a .deb that names few of the libraries it needs.
if(CPACK_GENERATOR STREQUAL "DEB")
  foreach(tool dpkg-shlibdeps file)
    find_program(found_${tool} ${tool})
    if(NOT found_${tool})
      message(FATAL_ERROR "A .deb needs ${tool} (Debian/Ubuntu: sudo apt-get install dpkg-dev file). "
                          "cpack -G TGZ makes the archive alone.")
    endif()
  endforeach()
endif()
