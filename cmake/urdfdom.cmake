# Finds urdfdom, 1.0 or later: HIDWA_ROBOT says whether src/robot can be built, hidwa_urdfdom is what it links.

find_package(urdfdom_headers QUIET)
find_package(urdfdom QUIET)
find_package(console_bridge QUIET)  # by which it logs
if(urdfdom_FOUND AND console_bridge_FOUND)
  set(HIDWA_ROBOT ON)
else()
  set(HIDWA_ROBOT OFF)
endif()
if(NOT HIDWA_ROBOT AND HIDWA_ROS)
  message(FATAL_ERROR "urdfdom or console_bridge not found: install liburdfdom-dev and libconsole-bridge-dev")
elseif(NOT HIDWA_ROBOT)
  message(STATUS "urdfdom or console_bridge not found: no limits from the URDF")
else()
  add_library(hidwa_urdfdom INTERFACE)
  # Named by its real path, /usr/include is left to the compiler, which knows it.
  foreach(folder ${urdfdom_INCLUDE_DIRS} ${urdfdom_headers_INCLUDE_DIRS})
    get_filename_component(folder ${folder} REALPATH)
    target_include_directories(hidwa_urdfdom SYSTEM INTERFACE ${folder})
  endforeach()
  target_link_libraries(hidwa_urdfdom INTERFACE ${urdfdom_LIBRARIES} ${console_bridge_LIBRARIES})
endif()
