# The build for browsers (docs/web.md): header-only libraries of Debian's -dev packages through one folder of
# links, so that nothing else of the system is seen, and those that third_party/web/libraries.sh compiles from Debian's
# source packages. Under the names that third_party/dependencies.cmake gives them elsewhere.

find_package(Threads REQUIRED)
# Debian's, which has Debian's modules, before another that stands in the way.
find_program(Python3_EXECUTABLE python3 PATHS /usr/bin NO_DEFAULT_PATH)
find_program(Python3_EXECUTABLE python3)
set(web_libraries ${CMAKE_SOURCE_DIR}/build/web-libraries CACHE PATH "Made by third_party/web/libraries.sh")
if(NOT EXISTS ${web_libraries}/done)
  message(FATAL_ERROR "The libraries of the build for browsers are not there: run third_party/web/libraries.sh "
                      "(./check web does).")
endif()

# weftlight_web_library(TARGET [LIBRARY file] [INCLUDE folder] [DEFINE ...])
function(weftlight_web_library target)
  cmake_parse_arguments(ARG "" "LIBRARY;INCLUDE" "DEFINE" ${ARGN})
  add_library(${target} INTERFACE IMPORTED GLOBAL)
  target_include_directories(${target} SYSTEM INTERFACE ${web_libraries}/include ${ARG_INCLUDE})
  target_compile_definitions(${target} INTERFACE ${ARG_DEFINE})
  if(ARG_LIBRARY)
    target_link_libraries(${target} INTERFACE ${web_libraries}/lib/${ARG_LIBRARY})
  endif()
endfunction()

weftlight_web_library(fmt::fmt DEFINE FMT_HEADER_ONLY=1)
weftlight_web_library(tl::expected)
weftlight_web_library(glm::glm)
weftlight_web_library(nlohmann_json::nlohmann_json)
weftlight_web_library(TinyGLTF::TinyGLTF LIBRARY libtinygltf.a DEFINE TINYGLTF_NO_STB_IMAGE TINYGLTF_NO_STB_IMAGE_WRITE
                      TINYGLTF_NO_INCLUDE_STB_IMAGE TINYGLTF_NO_INCLUDE_STB_IMAGE_WRITE)
weftlight_web_library(stb)
weftlight_web_library(ZLIB::ZLIB LIBRARY libz.a)
weftlight_web_library(meshoptimizer::meshoptimizer LIBRARY libmeshoptimizer.a)

weftlight_web_library(PkgConfig::FREETYPE LIBRARY libfreetype.a)
weftlight_web_library(PkgConfig::IMGUI LIBRARY libimgui.a INCLUDE ${web_libraries}/include/imgui)
target_include_directories(PkgConfig::IMGUI SYSTEM INTERFACE ${web_libraries}/include/imgui/misc/freetype
                           ${web_libraries}/include/imgui/misc/cpp)
target_link_libraries(PkgConfig::IMGUI INTERFACE PkgConfig::FREETYPE)
# WebGL 2 as OpenGL ES 3.0, and GLFW, are Emscripten's own; what its GLFW lacks stands in third_party/web.
add_library(PkgConfig::EPOXY INTERFACE IMPORTED GLOBAL)
target_link_options(PkgConfig::EPOXY INTERFACE -sMIN_WEBGL_VERSION=2 -sMAX_WEBGL_VERSION=2)
weftlight_web_library(glfw)
target_link_options(glfw INTERFACE -sUSE_GLFW=3 --js-library ${CMAKE_SOURCE_DIR}/third_party/web/glfw_rest.js)
target_link_libraries(PkgConfig::IMGUI INTERFACE glfw)

set(web_flags -pthread -fwasm-exceptions -sSUPPORT_LONGJMP=wasm)
add_compile_options(${web_flags})
include_directories(SYSTEM ${CMAKE_SOURCE_DIR}/third_party/web/include)
# Before every file, and compiled once: that saves a third of the time of a file. Without the times of its files, so that
# ccache knows it again in another tree.
set(first ${CMAKE_BINARY_DIR}/before_every_file.h)
configure_file(${CMAKE_SOURCE_DIR}/third_party/web/before_every_file.h ${first} COPYONLY)
set_property(DIRECTORY ${CMAKE_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS
             ${CMAKE_SOURCE_DIR}/third_party/web/standard_library.h)
separate_arguments(first_flags UNIX_COMMAND "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_RELEASE}")
execute_process(
  COMMAND ${CMAKE_CXX_COMPILER} ${first_flags} ${web_flags} -std=c++20 -DFMT_HEADER_ONLY=1 -Xclang -fno-pch-timestamp
          -I${CMAKE_SOURCE_DIR}/third_party/web -isystem ${CMAKE_SOURCE_DIR}/third_party/web/include
          -isystem ${web_libraries}/include -x c++-header ${first} -o ${first}.pch
  COMMAND_ERROR_IS_FATAL ANY)
add_compile_options("SHELL:-include ${first}")
add_link_options(${web_flags})
add_library(web_standard_library STATIC ${CMAKE_SOURCE_DIR}/third_party/web/standard_library.cpp)
target_link_libraries(web_standard_library PUBLIC fmt::fmt)
link_libraries(web_standard_library)
