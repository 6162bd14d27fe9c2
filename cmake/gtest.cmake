# Finds what the tests take beside the planner's own libraries: GTest. hidwa_gtest holds what a test with its own main() out
# of GTest links, or nothing.

# CMake before 3.20 knows the libraries as GTest::GTest and GTest::Main only; GTest's own files, and CMake since then,
# as GTest::gtest and GTest::gtest_main.
find_package(GTest QUIET)
set(hidwa_gtest)
foreach(library GTest::gtest_main GTest::Main GTest::gtest GTest::GTest)
  if(TARGET ${library})
    list(APPEND hidwa_gtest ${library})
  endif()
endforeach()
