// SPDX-License-Identifier: BSD-3-Clause
// map_server <map.yaml>: offers the map as latched topics `map` and `map_metadata` and as service
// `static_map`.
#include <map_server/image_loader.h>
#include <nav_msgs/GetMap.h>
#include <ros/ros.h>

#include <stdexcept>

int main(int argc, char** argv) {
  ros::init(argc, argv, "map_server", ros::init_options::AnonymousName);
  if (argc != 2) {
    ROS_FATAL("Usage: map_server MAP.yaml");
    return 1;
  }
  try {
    const map_server::MapDescription description = map_server::readDescription(argv[1]);
    nav_msgs::OccupancyGrid map =
        map_server::makeMap(map_server::readPicture(description.image, description.mode), description);

    ros::NodeHandle nh;
    ros::Time::waitForValid();
    map.header.frame_id = ros::NodeHandle("~").param<std::string>("frame_id", "map");
    map.header.stamp = map.info.map_load_time = ros::Time::now();

    const auto map_publisher = nh.advertise<nav_msgs::OccupancyGrid>("map", 1, true);
    const auto data_publisher = nh.advertise<nav_msgs::MapMetaData>("map_metadata", 1, true);
    map_publisher.publish(map);
    data_publisher.publish(map.info);
    const boost::function<bool(nav_msgs::GetMap::Request&, nav_msgs::GetMap::Response&)> answer =
        [&map](nav_msgs::GetMap::Request&, nav_msgs::GetMap::Response& response) {
          response.map = map;
          return true;
        };
    const auto service = nh.advertiseService("static_map", answer);
    ROS_INFO("Map of %u x %u cells of %.3f m from %s", map.info.width, map.info.height, double(map.info.resolution),
             description.image.c_str());
    ros::spin();
  } catch (const std::exception& fault) {
    ROS_FATAL("%s", fault.what());
    return 1;
  }
  return 0;
}
