# One test of ctest for each suite of a program of gtest's, so that what a suite sets up (a context of OpenGL and its
# programs, above all) is set up once, and the libraries are loaded once: a case of its own would cost a fifth of a second
# for those alone. The program is asked for its suites when ctest starts, where it is newer than its last answer.
# weftlight_suites(gl gl_test FIXTURES_REQUIRED drawing): with more properties of its tests.
function(weftlight_suites prefix program)
  set(script ${CMAKE_CURRENT_BINARY_DIR}/${prefix}_suites.cmake)
  file(GENERATE OUTPUT ${script} CONTENT
"set(prefix ${prefix})
set(program \"$<TARGET_FILE:${program}>\")
set(answer \"${CMAKE_CURRENT_BINARY_DIR}/${prefix}_answer.cmake\")
set(properties \"SKIP_RETURN_CODE;77;TIMEOUT;1500;${ARGN}\")
set(script \"${script}\")
include(${CMAKE_CURRENT_FUNCTION_LIST_DIR}/list_suites.cmake)
")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${script})
endfunction()
