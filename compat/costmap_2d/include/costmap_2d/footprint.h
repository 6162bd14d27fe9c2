// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/Point.h>
#include <geometry_msgs/Point32.h>
#include <geometry_msgs/Polygon.h>
#include <geometry_msgs/PolygonStamped.h>
#include <ros/node_handle.h>
#include <xmlrpcpp/XmlRpcValue.h>

#include <string>
#include <vector>

namespace costmap_2d {

/// Least and greatest distance [m] from the robot's centre to the outline.
void calculateMinAndMaxDistances(const std::vector<geometry_msgs::Point>& footprint, double& min_dist,
                                 double& max_dist);

geometry_msgs::Point toPoint(geometry_msgs::Point32 pt);
geometry_msgs::Point32 toPoint32(geometry_msgs::Point pt);
geometry_msgs::Polygon toPolygon(std::vector<geometry_msgs::Point> pts);
std::vector<geometry_msgs::Point> toPointVector(geometry_msgs::Polygon polygon);

/// The footprint at pose (x, y, theta) [m, m, rad].
void transformFootprint(double x, double y, double theta,
                        const std::vector<geometry_msgs::Point>& footprint_spec,
                        std::vector<geometry_msgs::Point>& oriented_footprint);
void transformFootprint(double x, double y, double theta,
                        const std::vector<geometry_msgs::Point>& footprint_spec,
                        geometry_msgs::PolygonStamped& oriented_footprint);

/// Moves each corner outwards by `padding` [m] on each axis on which it does not lie.
void padFootprint(std::vector<geometry_msgs::Point>& footprint, double padding);

/// A circle as a polygon of 16 corners.
std::vector<geometry_msgs::Point> makeFootprintFromRadius(double radius);

/// Reads "[[x, y], [x, y], ...]" [m]; false, with an error logged, when the text is not three or more such
/// pairs.
bool makeFootprintFromString(const std::string& footprint_string,
                             std::vector<geometry_msgs::Point>& footprint);

/// Reads the same as a parameter list; throws std::runtime_error naming the parameter when it is not one.
std::vector<geometry_msgs::Point> makeFootprintFromXMLRPC(XmlRpc::XmlRpcValue& footprint_xmlrpc,
                                                          const std::string& full_param_name);

/// The parameter `footprint`, else `robot_radius`, here or in the nearest namespace above; empty when neither
/// is set.
std::vector<geometry_msgs::Point> makeFootprintFromParams(ros::NodeHandle& nh);

/// Writes the parameter `footprint` as a list of pairs.
void writeFootprintToParam(ros::NodeHandle& nh, const std::vector<geometry_msgs::Point>& footprint);

}  // namespace costmap_2d
