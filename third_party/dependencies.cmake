# How each dependency is found. A missing one stops the configure step and names
# the Debian package that brings it (third_party/packages.txt holds them all).
# Debian's and Ubuntu's names come first; where a system has others, CMake's own modules
# and configuration files are asked.

function(weftlight_missing what package)
  message(FATAL_ERROR
    "Weftlight needs ${what}. Install the package '${package}' "
    "(Debian/Ubuntu: sudo apt-get install ${package}; or let ./run install all of third_party/packages.txt).")
endfunction()

# weftlight_package(NAME debian-package [VERSION] [CONFIG]): through CMake.
macro(weftlight_package name package)
  find_package(${name} ${ARGN} QUIET)
  if(NOT ${name}_FOUND)
    weftlight_missing("${name}" ${package})
  endif()
endmacro()

# weftlight_pkg(PREFIX module debian-package [NAME target [COMPONENTS ...]]): PkgConfig::PREFIX through pkg-config,
# else find_package(NAME COMPONENTS ...), whose target it then stands for.
function(weftlight_pkg prefix module package)
  pkg_check_modules(${prefix} QUIET IMPORTED_TARGET GLOBAL ${module})
  set(${prefix}_VERSION "${${prefix}_VERSION}" PARENT_SCOPE)
  if(${prefix}_FOUND)
    return()
  endif()
  if(ARGC GREATER 4)
    list(SUBLIST ARGN 2 -1 parts)
    find_package(${ARGV3} ${parts} QUIET)
    if(TARGET ${ARGV4})
      add_library(PkgConfig::${prefix} INTERFACE IMPORTED GLOBAL)
      target_link_libraries(PkgConfig::${prefix} INTERFACE ${ARGV4})
      set(${prefix}_VERSION "${${ARGV3}_VERSION}" PARENT_SCOPE)
      return()
    endif()
  endif()
  weftlight_missing("${module}" ${package})
endfunction()

if(EMSCRIPTEN)
  include(${CMAKE_CURRENT_LIST_DIR}/web/dependencies.cmake)
  return()
endif()
if(MINGW AND CMAKE_CROSSCOMPILING)
  include(${CMAKE_CURRENT_LIST_DIR}/windows/dependencies.cmake)
  return()
endif()

find_program(WEFTLIGHT_PKG_CONFIG NAMES pkg-config pkgconf)
if(NOT WEFTLIGHT_PKG_CONFIG)
  weftlight_missing("pkg-config" pkg-config)
endif()
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)

if(WEFTLIGHT_TBB)
  weftlight_package(TBB libtbb-dev CONFIG)
endif()
if(NOT WIN32)
  weftlight_pkg(FONTCONFIG fontconfig libfontconfig-dev Fontconfig Fontconfig::Fontconfig)
endif()
weftlight_package(fmt libfmt-dev CONFIG)
weftlight_package(tl-expected libexpected-dev CONFIG)
weftlight_package(glm libglm-dev CONFIG)
weftlight_package(glfw3 libglfw3-dev 3.3 CONFIG)
weftlight_package(nlohmann_json nlohmann-json3-dev CONFIG)
find_package(TinyGLTF CONFIG QUIET)
if(NOT TARGET TinyGLTF::TinyGLTF)
  # Elsewhere than in Debian it is one header, which holds its source.
  find_path(TINYGLTF_INCLUDE_DIR tiny_gltf.h)
  if(NOT TINYGLTF_INCLUDE_DIR)
    weftlight_missing("tinygltf" libtinygltf-dev)
  endif()
  file(WRITE ${CMAKE_BINARY_DIR}/tinygltf.cpp "#define TINYGLTF_IMPLEMENTATION\n"
    "#define TINYGLTF_NO_INCLUDE_STB_IMAGE\n#define TINYGLTF_NO_INCLUDE_STB_IMAGE_WRITE\n#include <tiny_gltf.h>\n")
  add_library(tinygltf STATIC ${CMAKE_BINARY_DIR}/tinygltf.cpp)
  target_include_directories(tinygltf SYSTEM PUBLIC ${TINYGLTF_INCLUDE_DIR})
  target_compile_definitions(tinygltf PUBLIC TINYGLTF_NO_STB_IMAGE TINYGLTF_NO_STB_IMAGE_WRITE)
  target_link_libraries(tinygltf PUBLIC nlohmann_json::nlohmann_json)
  add_library(TinyGLTF::TinyGLTF ALIAS tinygltf)
endif()
# Debian 12 has Embree 3; Ubuntu 24.04 and Debian 13 bring version 4, which refuses to stand in for 3.
if(WEFTLIGHT_EMBREE)
  find_package(embree 4 CONFIG QUIET)
  if(NOT embree_FOUND)
    weftlight_package(embree libembree-dev 3.12 CONFIG)
  endif()
  weftlight_pkg(NLOPT nlopt libnlopt-dev NLopt NLopt::nlopt CONFIG)
endif()
weftlight_package(CLI11 libcli11-dev CONFIG)
weftlight_package(ZLIB zlib1g-dev)
weftlight_package(meshoptimizer libmeshoptimizer-dev CONFIG)

# editor/ui/imgui_compat holds what differs between these versions.
weftlight_pkg(IMGUI imgui libimgui-dev imgui imgui::imgui CONFIG)
if(IMGUI_VERSION VERSION_LESS 1.86)
  message(FATAL_ERROR "Weftlight takes Dear ImGui from 1.86 on; this is ${IMGUI_VERSION}.")
endif()
message(STATUS "Dear ImGui ${IMGUI_VERSION} (1.86 to 1.92 will do)")

# Debian's Dear ImGui holds its FreeType builder but does not name the library.
weftlight_pkg(FREETYPE freetype2 libfreetype-dev Freetype Freetype::Freetype)
weftlight_pkg(EPOXY epoxy libepoxy-dev)
if(WEFTLIGHT_EGL)
  weftlight_pkg(EGL egl libegl-dev OpenGL OpenGL::EGL COMPONENTS EGL)
endif()
if(WEFTLIGHT_CAIRO)
  weftlight_pkg(CAIRO cairo libcairo2-dev)
endif()
if(UNIX AND NOT APPLE)
  weftlight_pkg(XCB xcb libxcb1-dev)
endif()
# Headers alone, without a pkg-config file on Debian 12.
find_path(ASIO_INCLUDE_DIR asio.hpp)
if(NOT ASIO_INCLUDE_DIR)
  weftlight_missing("asio" libasio-dev)
endif()
add_library(asio INTERFACE)
target_include_directories(asio SYSTEM INTERFACE ${ASIO_INCLUDE_DIR})
target_compile_definitions(asio INTERFACE ASIO_STANDALONE)
# Headers alone: the grammar of HTTP.
find_path(BEAST_INCLUDE_DIR boost/beast/http/parser.hpp)
if(NOT BEAST_INCLUDE_DIR)
  weftlight_missing("Boost.Beast" libboost-dev)
endif()
add_library(beast INTERFACE)
target_include_directories(beast SYSTEM INTERFACE ${BEAST_INCLUDE_DIR})
# OpenImageIO's CMake targets on Debian 12 name an OpenCV folder that need not exist;
# its pkg-config file does not.
weftlight_pkg(OIIO OpenImageIO libopenimageio-dev OpenImageIO OpenImageIO::OpenImageIO CONFIG)

if(WEFTLIGHT_TESTS)
  weftlight_package(GTest libgtest-dev)
  weftlight_package(benchmark libbenchmark-dev CONFIG)
endif()

# The module for Python can be left out (WEFTLIGHT_PYTHON). NumPy is needed where it runs, not where it is built.
# The system's own Python, for which Debian's NumPy is, comes before one that a user has put into PATH.
if(NOT Python3_EXECUTABLE AND EXISTS /usr/bin/python3)
  set(Python3_EXECUTABLE /usr/bin/python3)
endif()
find_package(Python3 3.9 COMPONENTS Interpreter Development.Module QUIET)
set(PYBIND11_FINDPYTHON OFF)
set(PYBIND11_NOPYTHON ON)  # its headers alone
find_package(pybind11 2.10 CONFIG QUIET)
function(weftlight_need_python)
  if(NOT Python3_Development.Module_FOUND)
    weftlight_missing("Python's headers" python3-dev)
  endif()
  if(NOT pybind11_FOUND)
    weftlight_missing("pybind11" pybind11-dev)
  endif()
endfunction()
