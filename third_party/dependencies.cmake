# How each dependency is found. A missing one stops the configure step and names
# the Debian package that brings it (third_party/packages.txt holds them all).

function(weftlight_missing what package)
  message(FATAL_ERROR
    "Weftlight needs ${what}. Install the package '${package}' "
    "(Debian/Ubuntu: sudo apt-get install ${package}; or let ./run install all of third_party/packages.txt).")
endfunction()

macro(weftlight_package name package)
  find_package(${name} ${ARGN} QUIET)
  if(NOT ${name}_FOUND)
    weftlight_missing("${name}" ${package})
  endif()
endmacro()

macro(weftlight_pkg prefix module package)
  pkg_check_modules(${prefix} QUIET IMPORTED_TARGET ${module})
  if(NOT ${prefix}_FOUND)
    weftlight_missing("${module}" ${package})
  endif()
endmacro()

find_program(WEFTLIGHT_PKG_CONFIG NAMES pkg-config pkgconf)
if(NOT WEFTLIGHT_PKG_CONFIG)
  weftlight_missing("pkg-config" pkg-config)
endif()
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)

weftlight_package(TBB libtbb-dev CONFIG)
weftlight_pkg(FONTCONFIG fontconfig libfontconfig-dev)
weftlight_package(glm libglm-dev CONFIG)
weftlight_package(glfw3 libglfw3-dev 3.3 CONFIG)
weftlight_package(TinyGLTF libtinygltf-dev CONFIG)
# Ubuntu 24.04 brings version 4, which refuses to stand in for 3.
find_package(embree 4 CONFIG QUIET)
if(NOT embree_FOUND)
  weftlight_package(embree libembree-dev 3.12 CONFIG)
endif()
weftlight_package(CLI11 libcli11-dev CONFIG)
weftlight_package(nlohmann_json nlohmann-json3-dev CONFIG)
weftlight_package(meshoptimizer libmeshoptimizer-dev CONFIG)
weftlight_pkg(IMGUI imgui libimgui-dev)
# Debian's Dear ImGui holds its FreeType builder but does not name the library.
weftlight_pkg(FREETYPE freetype2 libfreetype-dev)
weftlight_pkg(EPOXY epoxy libepoxy-dev)
weftlight_pkg(EGL egl libegl-dev)
weftlight_pkg(CAIRO cairo libcairo2-dev)
weftlight_pkg(SERIALPORT libserialport libserialport-dev)
# OpenImageIO's CMake targets on Debian 12 name an OpenCV folder that need not exist;
# its pkg-config file does not.
weftlight_pkg(OIIO OpenImageIO libopenimageio-dev)

if(WEFTLIGHT_TESTS)
  weftlight_package(GTest libgtest-dev)
  weftlight_package(benchmark libbenchmark-dev CONFIG)
endif()
