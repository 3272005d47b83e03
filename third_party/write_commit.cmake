# Writes OUT with the commit of SOURCE, and only if it is another than before: cmake -DSOURCE= -DOUT= -P
# A source package has no repository; WEFTLIGHT_COMMIT in the environment may name the commit there.
set(commit "$ENV{WEFTLIGHT_COMMIT}")
find_program(git git)
if(git AND commit STREQUAL "" AND EXISTS ${SOURCE}/.git)
  execute_process(COMMAND ${git} -C ${SOURCE} rev-parse --short=7 HEAD
    OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  execute_process(COMMAND ${git} -C ${SOURCE} diff-index --quiet HEAD -- RESULT_VARIABLE changed ERROR_QUIET)
  if(commit AND NOT changed EQUAL 0)
    string(APPEND commit ", changed")
  endif()
endif()
file(CONFIGURE OUTPUT ${OUT} CONTENT "#pragma once\n#define WEFTLIGHT_COMMIT \"${commit}\"\n")
