# What every target of this project shares: strict warnings, reproducible arithmetic, and how a gtest is added.

# Strict warnings are errors on our own targets only.
function(hidwa_warnings target)
  target_compile_options(${target} PRIVATE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wnon-virtual-dtor -Werror)
endfunction()

# Same input, same bits: no contraction of a*b+c, which would depend on the instruction set.
function(hidwa_arithmetic target)
  target_compile_options(${target} PRIVATE -ffp-contract=off)
endfunction()

# hidwa_add_gtest(name SOURCES a.cpp ... LIBRARIES lib ... [LABELS label ...] [TIMEOUT seconds])
# A plain gtest executable that ctest runs: the same under catkin and under plain CMake.
function(hidwa_add_gtest name)
  cmake_parse_arguments(ARG "" "TIMEOUT" "SOURCES;LIBRARIES;LABELS" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE ${ARG_LIBRARIES} GTest::gtest GTest::gtest_main)
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/test)
  hidwa_warnings(${name})
  hidwa_arithmetic(${name})
  add_test(NAME ${name} COMMAND ${name} --gtest_output=xml:${PROJECT_BINARY_DIR}/test_results/${name}.xml)
  if(ARG_LABELS)
    set_tests_properties(${name} PROPERTIES LABELS "${ARG_LABELS}")
  endif()
  if(ARG_TIMEOUT)
    set_tests_properties(${name} PROPERTIES TIMEOUT ${ARG_TIMEOUT})
  endif()
endfunction()
