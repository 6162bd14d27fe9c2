# SPDX-License-Identifier: BSD-3-Clause
# What the packages of compat/ share: C++17, an optimised build, strict warnings, gtests.

set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release)  # not in the cache: other packages of the workspace keep their own
endif()

option(HIDWA_WERROR "Warnings are errors; for the compilers that this is tried with" OFF)
option(COMPAT_TESTS "Build the tests" OFF)
if(COMPAT_TESTS)
  include(${CMAKE_CURRENT_LIST_DIR}/../../cmake/gtest.cmake)
  enable_testing()
endif()

function(compat_warnings target)
  target_compile_options(${target} PRIVATE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wnon-virtual-dtor $<$<BOOL:${HIDWA_WERROR}>:-Werror>)
endfunction()

# compat_gtest(name library...): the gtest name.cpp.
function(compat_gtest name)
  set(target compat_${name})
  add_executable(${target} ${name}.cpp)
  target_link_libraries(${target} PRIVATE ${ARGN} ${hidwa_gtest})
  compat_warnings(${target})
  add_test(NAME ${target} COMMAND ${target} --gtest_output=xml:${PROJECT_BINARY_DIR}/test_results/${target}.xml)
  set_tests_properties(${target} PROPERTIES TIMEOUT 60)
endfunction()

option(HIDWA_UNITY "Compile several sources of a library at once" OFF)
function(compat_unity target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${HIDWA_UNITY})
endfunction()
