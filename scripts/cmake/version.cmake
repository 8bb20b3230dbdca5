# Version and commit of the source, for reports and file headers. Written at build time and only when it changes, so
# that a new commit recompiles one file.
find_package(Git QUIET)
set(SANDSIM_GENERATED ${CMAKE_BINARY_DIR}/generated)
file(WRITE ${CMAKE_BINARY_DIR}/write_version.cmake.in [=[
set(commit "unknown")
if(GIT)
  execute_process(COMMAND ${GIT} -C ${SOURCE} rev-parse --short=12 HEAD
                  OUTPUT_VARIABLE found OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
  if(NOT failed)
    set(commit "${found}")
  endif()
endif()
set(text "#pragma once\n#define SANDSIM_VERSION \"${VERSION}\"\n#define SANDSIM_COMMIT \"${commit}\"\n")
set(old "")
if(EXISTS ${OUTPUT})
  file(READ ${OUTPUT} old)
endif()
if(NOT old STREQUAL text)
  file(WRITE ${OUTPUT} "${text}")
endif()
]=])
add_custom_target(sandsim_version
  COMMAND ${CMAKE_COMMAND} -DGIT=${GIT_EXECUTABLE} -DSOURCE=${CMAKE_SOURCE_DIR} -DVERSION=${PROJECT_VERSION}
          -DOUTPUT=${SANDSIM_GENERATED}/sandsim_version.h -P ${CMAKE_BINARY_DIR}/write_version.cmake.in
  BYPRODUCTS ${SANDSIM_GENERATED}/sandsim_version.h)
