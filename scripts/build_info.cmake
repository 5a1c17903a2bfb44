# Writes build_info.h: what the results' meta.json says of this build. Runs at every build, so that the
# commit is the one that was compiled; the file is touched only when something changed.
execute_process(COMMAND git rev-parse HEAD WORKING_DIRECTORY ${SOURCE_DIR}
  OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
set(dirty false)
if(failed)
  set(commit "unknown")
else()
  execute_process(COMMAND git status --porcelain --untracked-files=no WORKING_DIRECTORY ${SOURCE_DIR}
    OUTPUT_VARIABLE changes ERROR_QUIET)
  if(NOT changes STREQUAL "")
    set(dirty true)
  endif()
endif()
file(CONFIGURE OUTPUT ${OUTPUT} @ONLY CONTENT [[
#pragma once
#define CTPBENCH_VERSION "@VERSION@"
#define CTPBENCH_GIT_COMMIT "@commit@"
#define CTPBENCH_GIT_DIRTY @dirty@
#define CTPBENCH_COMPILER "@COMPILER@"
#define CTPBENCH_COMPILE_FLAGS "@FLAGS@"
#define CTPBENCH_BUILD_TYPE "@BUILD_TYPE@"
]])
