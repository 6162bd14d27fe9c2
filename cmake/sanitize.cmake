# Faults that a run shows: sanitizers, coverage and fuzzing, for the whole build. docs/evidence/trust.md says how they are used.

set(HIDWA_SANITIZE "" CACHE STRING "Sanitizers of GCC or Clang for everything that is built: address,undefined or thread; empty: none")
option(HIDWA_COVERAGE "Count which lines and branches run, for gcovr" OFF)
option(HIDWA_FUZZ "Build the targets of test/fuzz with libFuzzer, which takes Clang; OFF: they replay their corpus" OFF)

# Beyond `undefined`: what only some compilers count to it. The first finding ends the program.
set(hidwa_sanitize_flags)
if(HIDWA_SANITIZE)
  set(hidwa_sanitize_flags -fsanitize=${HIDWA_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer -g1)
  if(HIDWA_SANITIZE MATCHES "undefined")
    list(APPEND hidwa_sanitize_flags -fsanitize=float-cast-overflow)
  endif()
endif()
if(HIDWA_FUZZ)
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    message(FATAL_ERROR "HIDWA_FUZZ needs Clang with its run-time libraries (Debian: libclang-rt-dev): set CMAKE_CXX_COMPILER=clang++, or HIDWA_FUZZ=OFF")
  endif()
  list(APPEND hidwa_sanitize_flags -fsanitize=fuzzer-no-link)
endif()
if(HIDWA_COVERAGE)
  list(APPEND hidwa_sanitize_flags --coverage -fprofile-update=atomic -g1)
endif()
if(hidwa_sanitize_flags)
  add_compile_options(${hidwa_sanitize_flags})
  add_link_options(${hidwa_sanitize_flags})
endif()

# Under a sanitizer a test takes several times as long.
set(HIDWA_TIMEOUT_FACTOR 1)
if(HIDWA_SANITIZE OR HIDWA_COVERAGE)
  set(HIDWA_TIMEOUT_FACTOR 20)
endif()
