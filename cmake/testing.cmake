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

# hidwa_register_test(target RESULTS file COMMAND word ... [DEPENDS target] [PROPERTIES name value ...])
# COMMAND leaves RESULTS, a file in HIDWA_TEST_RESULTS in the format of xunit.
function(hidwa_register_test target)
  cmake_parse_arguments(ARG "" "RESULTS;DEPENDS" "COMMAND;PROPERTIES" ${ARGN})
  set(test ${target})
  if(HIDWA_ROS)
    string(REPLACE ";" " " command "${ARG_COMMAND}")  # catkin takes it as one word, for a shell
    catkin_run_tests_target(gtest ${target} ${ARG_RESULTS} COMMAND "${command}" DEPENDENCIES ${ARG_DEPENDS})
    set(test _ctest_${PROJECT_NAME}_gtest_${target})
  else()
    add_test(NAME ${test} COMMAND ${ARG_COMMAND})
  endif()
  if(ARG_PROPERTIES)
    set_tests_properties(${test} PROPERTIES ${ARG_PROPERTIES})
  endif()
endfunction()

# hidwa_add_gtest(name SOURCES a.cpp ... LIBRARIES lib ... [DEFINITIONS NAME=value ...] [LABELS label ...] [TIMEOUT seconds]
#   [COMPUTES])
# A gtest, target hidwa_name. Under catkin it belongs to the target `tests`, which a build leaves out. COMPUTES: its own
# code takes long to run. That of the others takes longer to compile than to run, and is hardly optimised.
function(hidwa_add_gtest name)
  cmake_parse_arguments(ARG "COMPUTES" "TIMEOUT" "SOURCES;LIBRARIES;DEFINITIONS;LABELS" ${ARGN})
  hidwa_prefixed(${name} target)
  add_executable(${target} ${ARG_SOURCES})
  target_link_libraries(${target} PRIVATE ${ARG_LIBRARIES} ${hidwa_gtest})
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/test)
  target_compile_definitions(${target} PRIVATE ${ARG_DEFINITIONS})
  hidwa_warnings(${target})
  hidwa_arithmetic(${target})
  if(NOT ARG_COMPUTES)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
  endif()
  if(HIDWA_ROS)
    set_target_properties(${target} PROPERTIES EXCLUDE_FROM_ALL ON)
    add_dependencies(tests ${target})
  endif()
  set(properties)
  if(ARG_LABELS)
    list(APPEND properties LABELS "${ARG_LABELS}")
  endif()
  if(ARG_TIMEOUT)
    math(EXPR timeout "${HIDWA_TIMEOUT_FACTOR} * ${ARG_TIMEOUT}")
    list(APPEND properties TIMEOUT ${timeout} COST ${ARG_TIMEOUT})  # what takes longest begins first
  endif()
  set(results gtest-${target}.xml)
  hidwa_register_test(${target} RESULTS ${results} DEPENDS ${target} PROPERTIES ${properties}
    COMMAND $<TARGET_FILE:${target}> --gtest_output=xml:${HIDWA_TEST_RESULTS}/${results})
endfunction()

# hidwa_add_program_test(name COMMAND word ... [PROPERTIES name value ...])
# A program that tells by its exit status how it went; 77: left out.
function(hidwa_add_program_test name)
  cmake_parse_arguments(ARG "" "" "COMMAND;PROPERTIES" ${ARGN})
  hidwa_prefixed(${name} test)
  set(results program-${test}.xml)
  hidwa_register_test(${test} RESULTS ${results} PROPERTIES SKIP_RETURN_CODE 77 ${ARG_PROPERTIES}
    COMMAND /usr/bin/python3 ${PROJECT_SOURCE_DIR}/test/support/program_test.py
      ${HIDWA_TEST_RESULTS}/${results} ${test} ${ARG_COMMAND})
endfunction()

set(HIDWA_FUZZ_MUTATIONS 20 CACHE STRING "Mutations of each file of the corpus that the tests try")

# hidwa_add_fuzz_target(name LIBRARIES lib ... [SOURCES file ...]): out of name.cpp, which has LLVMFuzzerTestOneInput. With
# HIDWA_FUZZ a program of libFuzzer (scripts/fuzz); always a test that gives it the kept corpus and some fixed mutations of it.
function(hidwa_add_fuzz_target name)
  cmake_parse_arguments(ARG "" "" "LIBRARIES;SOURCES" ${ARGN})
  set(kinds replay)
  if(HIDWA_FUZZ)
    list(APPEND kinds fuzz)
  endif()
  foreach(kind ${kinds})
    set(target hidwa_${kind}_${name})
    add_executable(${target} ${name}.cpp ${ARG_SOURCES})
    target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/test ${PROJECT_SOURCE_DIR}/src)
    target_link_libraries(${target} PRIVATE ${ARG_LIBRARIES})
    hidwa_warnings(${target})
    hidwa_arithmetic(${target})
  endforeach()
  target_sources(hidwa_replay_${name} PRIVATE ${PROJECT_SOURCE_DIR}/test/fuzz/replay.cpp)
  if(HIDWA_FUZZ)
    target_link_options(hidwa_fuzz_${name} PRIVATE -fsanitize=fuzzer)
  endif()
  hidwa_add_program_test(fuzz_${name}_test PROPERTIES LABELS fuzz
    COMMAND $<TARGET_FILE:hidwa_replay_${name}> --mutations=${HIDWA_FUZZ_MUTATIONS} ${PROJECT_SOURCE_DIR}/test/fuzz/corpus/${name})
endfunction()
