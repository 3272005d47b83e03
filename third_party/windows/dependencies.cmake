# The build for Windows by mingw-w64 (docs/other_systems.md): header-only libraries of Debian's -dev packages through one
# folder of links, so that nothing else of the system is seen, and those that third_party/windows/libraries.sh compiles from
# Debian's source packages. Under the names that third_party/dependencies.cmake gives them elsewhere.

find_package(Threads REQUIRED)
find_program(Python3_EXECUTABLE python3 PATHS /usr/bin NO_DEFAULT_PATH)  # for the handbook
weftlight_package(ZLIB libz-mingw-w64-dev)
set(windows_libraries ${CMAKE_SOURCE_DIR}/build/windows-libraries CACHE PATH "Made by third_party/windows/libraries.sh")
if(NOT EXISTS ${windows_libraries}/done)
  message(FATAL_ERROR "The libraries of the build for Windows are not there: run third_party/windows/libraries.sh "
                      "(./check windows does).")
endif()

# weftlight_windows_library(TARGET [LINK file or library ...] [INCLUDE folder ...] [DEFINE ...])
function(weftlight_windows_library target)
  cmake_parse_arguments(ARG "" "" "LINK;INCLUDE;DEFINE" ${ARGN})
  add_library(${target} INTERFACE IMPORTED GLOBAL)
  target_include_directories(${target} SYSTEM INTERFACE ${windows_libraries}/include ${ARG_INCLUDE})
  target_compile_definitions(${target} INTERFACE ${ARG_DEFINE})
  target_link_libraries(${target} INTERFACE ${ARG_LINK})
endfunction()

weftlight_windows_library(fmt::fmt DEFINE FMT_HEADER_ONLY=1)
weftlight_windows_library(tl::expected)
weftlight_windows_library(glm::glm)
weftlight_windows_library(nlohmann_json::nlohmann_json)
weftlight_windows_library(CLI11::CLI11)
weftlight_windows_library(stb)
weftlight_windows_library(asio DEFINE ASIO_STANDALONE LINK ws2_32 mswsock)
weftlight_windows_library(beast LINK ws2_32 mswsock)
weftlight_windows_library(TinyGLTF::TinyGLTF LINK ${windows_libraries}/lib/libtinygltf.a
                          DEFINE TINYGLTF_NO_STB_IMAGE TINYGLTF_NO_STB_IMAGE_WRITE)
weftlight_windows_library(meshoptimizer::meshoptimizer LINK ${windows_libraries}/lib/libmeshoptimizer.a)
weftlight_windows_library(PkgConfig::FREETYPE LINK ${windows_libraries}/lib/libfreetype.a ZLIB::ZLIB)
set(prefix ${windows_libraries}/prefix)
weftlight_windows_library(PkgConfig::CAIRO LINK ${prefix}/lib/libcairo.a ${prefix}/lib/libpixman-1.a ${prefix}/lib/libpng16.a
                          ZLIB::ZLIB gdi32 msimg32 ssp INCLUDE ${prefix}/include/cairo DEFINE CAIRO_WIN32_STATIC_BUILD)
weftlight_windows_library(PkgConfig::EPOXY LINK ${windows_libraries}/lib/libepoxy.a opengl32 gdi32)
weftlight_windows_library(glfw LINK ${windows_libraries}/lib/libglfw.a gdi32 user32 shell32)
weftlight_windows_library(PkgConfig::IMGUI LINK ${windows_libraries}/lib/libimgui.a PkgConfig::FREETYPE glfw opengl32 imm32
                          INCLUDE ${windows_libraries}/include/imgui ${windows_libraries}/include/imgui/misc/freetype
                          ${windows_libraries}/include/imgui/misc/cpp)
weftlight_windows_library(GTest::gtest LINK ${windows_libraries}/lib/libgtest.a
                          INCLUDE /usr/src/googletest/googletest/include)

# Windows 10 is the oldest; its headers without what is old, and without the macros min and max.
add_compile_definitions(_WIN32_WINNT=0x0A00 WINVER=0x0A00 WIN32_LEAN_AND_MEAN NOMINMAX _USE_MATH_DEFINES)
# The programs need no libraries but those of Windows itself.
add_link_options(-static)
