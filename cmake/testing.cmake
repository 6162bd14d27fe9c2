# How tests are added: the same under plain CMake (ctest) and under catkin (ctest and run_tests).
# In a workspace of many packages the names of targets are shared: those of tests begin with hidwa_, too.

if(HIDWA_ROS)
  set(HIDWA_TEST_RESULTS ${CATKIN_TEST_RESULTS_DIR}/${PROJECT_NAME})
else()
  set(HIDWA_TEST_RESULTS ${PROJECT_BINARY_DIR}/test_results)
endif()
file(MAKE_DIRECTORY ${HIDWA_TEST_RESULTS})

# hidwa_prefixed(name variable): name with hidwa_ before it.
function(hidwa_prefixed name variable)
  if(NOT name MATCHES "^hidwa_")
    set(name hidwa_${name})
  endif()
  set(${variable} ${name} PARENT_SCOPE)
endfunction()

# hidwa_register_test(target RESULTS file COMMAND word ... [DEPENDS target] [LABELS label ...] [PROPERTIES name value ...])
# COMMAND leaves RESULTS, a file in HIDWA_TEST_RESULTS in the format of xunit.
function(hidwa_register_test target)
  cmake_parse_arguments(ARG "" "RESULTS;DEPENDS" "COMMAND;LABELS;PROPERTIES" ${ARGN})
  set(test ${target})
  if(HIDWA_ROS)
    string(REPLACE ";" " " command "${ARG_COMMAND}")  # catkin takes it as one word, for a shell
    catkin_run_tests_target(gtest ${target} ${ARG_RESULTS} COMMAND "${command}" DEPENDENCIES ${ARG_DEPENDS})
    set(test _ctest_${PROJECT_NAME}_gtest_${target})
  else()
    add_test(NAME ${test} COMMAND ${ARG_COMMAND})
    # In a shell that knows an installed planner its libraries would take the place of those that were built here.
    set_tests_properties(${test} PROPERTIES ENVIRONMENT LD_LIBRARY_PATH=)
  endif()
  set(labels ${ARG_LABELS})
  if(HIDWA_SANITIZE)  # one of its own, and a test of test/whole that builds it
    list(FILTER labels INCLUDE REGEX "^long$")
    list(APPEND labels sanitized)
    set_property(TEST ${test} PROPERTY FIXTURES_REQUIRED hidwa_sanitized)
  endif()
  set_property(TEST ${test} PROPERTY LABELS ${labels})
  if(ARG_PROPERTIES)
    set_tests_properties(${test} PROPERTIES ${ARG_PROPERTIES})
  endif()
endfunction()

# What most tests include, compiled once for each way in which tests are compiled. ccache takes such a header only where it is
# told so (scripts/test does).
function(hidwa_test_headers target kind)
  if(NOT HIDWA_UNITY)
    return()
  endif()
  set(shared hidwa_test_headers_${kind})
  if(NOT TARGET ${shared})
    file(WRITE ${PROJECT_BINARY_DIR}/${shared}.cpp "")
    add_library(${shared} OBJECT EXCLUDE_FROM_ALL ${PROJECT_BINARY_DIR}/${shared}.cpp)
    target_link_libraries(${shared} PRIVATE ${hidwa_gtest} Eigen3::Eigen)
    hidwa_test_options(${shared} ${kind})
    target_precompile_headers(${shared} PRIVATE <gtest/gtest.h> <Eigen/Core> <algorithm> <cmath> <functional> <map> <string> <vector>)
  endif()
  target_precompile_headers(${target} REUSE_FROM ${shared})
endfunction()

# How a test is compiled. `computes`: its own code takes long to run. That of the others takes longer to compile than to run,
# and is not optimised.
function(hidwa_test_options target kind)
  hidwa_warnings(${target})
  hidwa_arithmetic(${target})
  set(level 0)
  if(kind STREQUAL "computes")
    set(level 2)
  endif()
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O${level}>)
endfunction()

# hidwa_add_gtest(name SOURCES a.cpp ... LIBRARIES lib ... [DEFINITIONS NAME=value ...] [LABELS label ...] [TIMEOUT seconds]
#   [COMPUTES] [LONG seconds] [LONG_CASES Suite.Case ...])
# A gtest, target hidwa_name. Under catkin it belongs to the target `tests`, which a build leaves out. Its label is its folder in
# test/, unless LABELS says otherwise.
# LONG: with HIDWA_LONG=1 in its environment the program tries more cases (test/support/effort.hpp). That is a test of its own,
# hidwa_name_long, labelled `long`, which takes about so many seconds. LONG_CASES belong to that one alone.
function(hidwa_add_gtest name)
  cmake_parse_arguments(ARG "COMPUTES" "TIMEOUT;LONG" "SOURCES;LIBRARIES;DEFINITIONS;LABELS;LONG_CASES" ${ARGN})
  hidwa_prefixed(${name} target)
  set(kind brief)
  if(ARG_COMPUTES)
    set(kind computes)
  endif()
  add_executable(${target} ${ARG_SOURCES})
  target_link_libraries(${target} PRIVATE ${ARG_LIBRARIES} ${hidwa_gtest})
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/test)
  target_compile_definitions(${target} PRIVATE ${ARG_DEFINITIONS})
  hidwa_test_options(${target} ${kind})
  hidwa_test_headers(${target} ${kind})
  if(HIDWA_ROS)
    add_dependencies(tests ${target})
  endif()
  set(labels ${ARG_LABELS})
  if(NOT labels)
    file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR}/test ${CMAKE_CURRENT_SOURCE_DIR})
    string(REGEX REPLACE "/.*" "" labels ${folder})
  endif()
  set(brief)
  if(ARG_LONG_CASES)
    list(JOIN ARG_LONG_CASES ":" cases)
    set(brief --gtest_filter=-${cases})
  endif()
  hidwa_register_gtest(${target} ${target} "${ARG_TIMEOUT}" "${labels}" $<TARGET_FILE:${target}> ${brief})
  if(ARG_LONG)
    math(EXPR timeout "4 * ${ARG_LONG}")
    hidwa_register_gtest(${target}_long ${target} ${timeout} "${labels};long" env HIDWA_LONG=1 $<TARGET_FILE:${target}>)
  endif()
endfunction()

# One run of a program of GoogleTest as a test; what follows the labels is its command.
function(hidwa_register_gtest test target timeout labels)
  set(properties PROCESSORS 2)  # of those that scripts/test lets run at once
  if(timeout)
    math(EXPR timeout "${HIDWA_TIMEOUT_FACTOR} * ${timeout}")
    list(APPEND properties TIMEOUT ${timeout} COST ${timeout})  # what takes longest begins first
  endif()
  set(results gtest-${test}.xml)
  hidwa_register_test(${test} RESULTS ${results} DEPENDS ${target} LABELS ${labels} PROPERTIES ${properties}
    COMMAND ${ARGN} --gtest_output=xml:${HIDWA_TEST_RESULTS}/${results})
endfunction()

# hidwa_add_program_test(name LABELS label COMMAND word ... [PROPERTIES name value ...])
# A program that tells by its exit status how it went; 77: left out.
function(hidwa_add_program_test name)
  cmake_parse_arguments(ARG "" "" "COMMAND;LABELS;PROPERTIES" ${ARGN})
  hidwa_prefixed(${name} test)
  set(results program-${test}.xml)
  hidwa_register_test(${test} RESULTS ${results} LABELS ${ARG_LABELS} PROPERTIES SKIP_RETURN_CODE 77 ${ARG_PROPERTIES}
    COMMAND /usr/bin/python3 ${PROJECT_SOURCE_DIR}/test/support/program_test.py
      ${HIDWA_TEST_RESULTS}/${results} ${test} ${ARG_COMMAND})
endfunction()

# hidwa_add_fuzz_target(name LIBRARIES lib ... [SOURCES file ...]): out of name.cpp, which has LLVMFuzzerTestOneInput. With
# HIDWA_FUZZ a program of libFuzzer (scripts/fuzz), which begins with the kept corpus; else a test that gives it this corpus and
# some fixed mutations of it.
function(hidwa_add_fuzz_target name)
  cmake_parse_arguments(ARG "" "" "LIBRARIES;SOURCES" ${ARGN})
  set(target hidwa_replay_${name})
  if(HIDWA_FUZZ)
    set(target hidwa_fuzz_${name})
  endif()
  add_executable(${target} ${name}.cpp ${ARG_SOURCES})
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/test ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/lab)
  target_link_libraries(${target} PRIVATE ${ARG_LIBRARIES})
  hidwa_warnings(${target})
  hidwa_arithmetic(${target})
  if(HIDWA_ROS)
    add_dependencies(tests ${target})
  endif()
  if(HIDWA_FUZZ)
    target_link_options(${target} PRIVATE -fsanitize=fuzzer)
  else()
    target_sources(${target} PRIVATE ${PROJECT_SOURCE_DIR}/test/fuzz/replay.cpp)
    hidwa_add_program_test(fuzz_${name}_test LABELS fuzz
      COMMAND $<TARGET_FILE:${target}> --mutations=20 ${PROJECT_SOURCE_DIR}/test/fuzz/corpus/${name})
  endif()
endfunction()
