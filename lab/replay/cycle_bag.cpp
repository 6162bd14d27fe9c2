// SPDX-License-Identifier: BSD-3-Clause
#include "cycle_bag.hpp"

#include <new>
#include <set>
#include <stdexcept>

#include <ros/message_traits.h>
#include <rosbag/view.h>

#include "options.hpp"

namespace hidwa_local_planner {
namespace replay {
namespace {

constexpr const char* kRemedy = "record with record_cycles: true (the launch files' record:=FILE.bag does)";

}  // namespace

CycleBag::CycleBag(const std::string& path, const std::string& topic)
    : file_(path), topic_(topic), fault_(file_.fault()) {
  const std::string type = ros::message_traits::DataType<Cycle>::value();
  const std::string sum = ros::message_traits::MD5Sum<Cycle>::value();
  std::set<std::string> topics;
  bool other_release = false;
  rosbag::View all(file_.bag());
  for (const rosbag::ConnectionInfo* connection : all.getConnections()) {
    if (connection->datatype != type) continue;
    if (connection->md5sum == sum) {
      topics.insert(connection->topic);
    } else {
      other_release = true;
    }
  }
  const std::string cut = fault_.empty() ? "" : fault_ + "; ";
  if (topics.empty() && other_release) {
    throw UsageError(cut + path + ": its cycles are those of another release: use the one that recorded it");
  }
  if (topics.empty()) throw UsageError(cut + path + " holds no cycle: " + kRemedy);
  if (topic_.empty() && topics.size() > 1) {
    std::string names;
    for (const std::string& name : topics) names += " " + name;
    throw UsageError(path + " holds several planners' cycles: choose one by --topic, of" + names);
  }
  if (topic_.empty()) topic_ = *topics.begin();
  if (topics.count(topic_) == 0)
    throw UsageError(path + " holds no cycle on " + topic_ + ", but on " + *topics.begin());
}

void CycleBag::for_each(const std::function<bool(const Cycle&)>& call) {
  const auto damaged = [this](const std::string& why) {
    if (fault_.empty()) fault_ = "the bag is damaged (" + why + ")";
  };
  try {
    rosbag::View view(file_.bag(), rosbag::TopicQuery(topic_));
    for (const rosbag::MessageInstance& message : view) {
      const Cycle::ConstPtr cycle = message.instantiate<Cycle>();
      if (cycle && !call(*cycle)) return;
    }
  } catch (const ros::Exception& error) {  // rosbag's own are of this kind
    damaged(error.what());
  } catch (const std::bad_alloc&) {  // roscpp takes what a length asks for
    damaged("a message promises more than there is memory for");
  } catch (const std::length_error&) {
    damaged("a message promises more than there can be");
  }
}

}  // namespace replay
}  // namespace hidwa_local_planner
