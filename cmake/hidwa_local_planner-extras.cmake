# Read by find_package in a package that depends on this one. Our headers are C++17; GCC 9 takes C++14 where nobody says
# otherwise. Who says otherwise is left alone: messages need no C++17.
if(NOT CMAKE_CXX_STANDARD)
  set(CMAKE_CXX_STANDARD 17)
endif()
