# Move Base Flex is no dependency: where it is found its users get the planner as a controller (HIDWA_MBF).
# HIDWA_WITH_MBF=1 in the environment demands it (package.xml).

find_package(mbf_costmap_core QUIET)
find_package(mbf_msgs QUIET)
set(HIDWA_MBF OFF)
if(mbf_costmap_core_FOUND AND mbf_msgs_FOUND)
  set(HIDWA_MBF ON)
elseif("$ENV{HIDWA_WITH_MBF}" STREQUAL "1")
  message(FATAL_ERROR "HIDWA_WITH_MBF=1, but mbf_costmap_core or mbf_msgs was not found: install Move Base Flex, or unset it")
endif()

if(HIDWA_MBF)
  install(FILES mbf_plugins.xml DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
else()
  # What is installed exports what was built: takes the place of the package.xml that catkin_package() installs.
  file(READ package.xml manifest)
  string(REGEX REPLACE "[^\n]*<mbf_costmap_core [^\n]*\n" "" manifest "${manifest}")
  file(WRITE ${PROJECT_BINARY_DIR}/without_mbf/package.xml "${manifest}")
  install(FILES ${PROJECT_BINARY_DIR}/without_mbf/package.xml DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
endif()
