# The ROS side of the build: messages, dynamic_reconfigure, what other packages may use.

set(HIDWA_CATKIN_DEPENDS
  actionlib_msgs angles costmap_2d diagnostic_updater dynamic_reconfigure geometry_msgs nav_core nav_msgs pluginlib roscpp
  sensor_msgs std_msgs tf2 tf2_geometry_msgs tf2_ros topic_tools visualization_msgs)

find_package(catkin REQUIRED COMPONENTS message_generation ${HIDWA_CATKIN_DEPENDS})

add_message_files(DIRECTORY msg FILES
  CriticScore.msg Cycle.msg Evaluation.msg MovingObstacle.msg MovingObstacles.msg ObservedSector.msg OperatorState.msg Trajectory.msg
  TrajectoryScore.msg)
generate_messages(DEPENDENCIES geometry_msgs std_msgs)
generate_dynamic_reconfigure_options(cfg/HIDWAPlanner.cfg)
# Some versions of dynamic_reconfigure say SYSTEM BEFORE, and CMake takes the second word for a folder's name.
get_directory_property(include_folders INCLUDE_DIRECTORIES)
list(REMOVE_ITEM include_folders ${PROJECT_SOURCE_DIR}/BEFORE)
set_directory_properties(PROPERTIES INCLUDE_DIRECTORIES "${include_folders}")
# The .cfg reads the parameters' one declaration: made anew when that changes.
add_custom_command(
  OUTPUT ${CATKIN_DEVEL_PREFIX}/${CATKIN_PACKAGE_INCLUDE_DESTINATION}/HIDWAPlannerConfig.h
  DEPENDS ${PROJECT_SOURCE_DIR}/include/hidwa_local_planner/core/parameter_list.inc
          ${PROJECT_SOURCE_DIR}/scripts/lib/hidwa_tools/parameter_list.py APPEND)

catkin_package(
  INCLUDE_DIRS include
  LIBRARIES hidwa_core hidwa_tracking hidwa_local_planner
  CATKIN_DEPENDS message_runtime ${HIDWA_CATKIN_DEPENDS}
  DEPENDS EIGEN3
  CFG_EXTRAS hidwa_local_planner-extras.cmake)

set(HIDWA_LIB_DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION})
set(HIDWA_BIN_DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
set(HIDWA_INCLUDE_DESTINATION ${CATKIN_GLOBAL_INCLUDE_DESTINATION})
set(HIDWA_SHARE_DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})

install(DIRECTORY include/${PROJECT_NAME}/ DESTINATION ${CATKIN_PACKAGE_INCLUDE_DESTINATION})
install(FILES plugins.xml DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
include(cmake/mbf.cmake)
