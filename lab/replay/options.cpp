// SPDX-License-Identifier: BSD-3-Clause
#include "options.hpp"

#include "hidwa_local_planner/core/parameter_text.hpp"

namespace hidwa_local_planner {
namespace replay {
namespace {

record::ParameterChange change(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) throw UsageError("--set needs name=value, not '" + text + "'");
  record::ParameterChange change{text.substr(0, equals), text.substr(equals + 1)};
  Parameters trial;
  const std::string fault = set_parameter_text(trial, change.first, change.second);
  if (!fault.empty()) throw UsageError("--set: " + fault + "; docs/use/parameters.md lists the parameters");
  return change;
}

Moment moment(const std::string& text) {
  const std::optional<Moment> moment = moment_of(text);
  if (!moment) throw UsageError("--at needs seconds or ros:SECONDS, not '" + text + "'");
  return *moment;
}

std::string default_folder(const std::string& bag) {
  std::string name = bag.substr(bag.find_last_of('/') + 1);
  if (name.size() > 4 && name.compare(name.size() - 4, 4, ".bag") == 0) name.resize(name.size() - 4);
  return name + "_replay";
}

}  // namespace

Options parse(const std::vector<std::string>& arguments) {
  Options options;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string& argument = arguments[i];
    const auto value = [&]() -> const std::string& {
      if (i + 1 == arguments.size()) throw UsageError(argument + " needs a value");
      return arguments[++i];
    };
    if (argument == "-h" || argument == "--help") {
      options.help = true;
    } else if (argument == "--set") {
      options.changes.push_back(change(value()));
    } else if (argument == "--at") {
      options.at = moment(value());
    } else if (argument == "--topic") {
      options.topic = value();
    } else if (argument == "--out") {
      options.out = value();
    } else if (argument == "--no-picture") {
      options.picture = false;
    } else if (!argument.empty() && argument[0] == '-') {
      throw UsageError("there is no option " + argument + "; --help lists them");
    } else if (options.bag.empty()) {
      options.bag = argument;
    } else {
      throw UsageError("one bag at a time: " + options.bag + " or " + argument);
    }
  }
  if (options.help) return options;
  if (options.bag.empty()) throw UsageError("which bag? hidwa_replay BAG; --help says more");
  if (options.out.empty()) options.out = default_folder(options.bag);
  return options;
}

const char* help() {
  return "hidwa_replay BAG [--set NAME=VALUE]... [--at SECONDS] [--topic TOPIC] [--out DIR] [--no-picture]\n"
         "\n"
         "Repeats every cycle recorded in the bag (record_cycles: true, topic `cycle`) and compares to the bit. The\n"
         "last line counts cycles and differences.\n"
         "\n"
         "  --set NAME=VALUE  what would each cycle have decided with this parameter? Repeatable. Every cycle starts\n"
         "                    from its recorded state (open loop): the robot's way, and what the planner remembered\n"
         "                    before the cycle, stay the recorded ones. Writes changes.csv and changes.png.\n"
         "  --at SECONDS      explains the cycle at that time since the first record, or at that ROS time where no "
         "record is\n"
         "                    so late; --at ros:SECONDS is surely the ROS time, as logs print it: the last number in\n"
         "                    [1606014000.123, 71.250]. Every candidate, scored by every critic to the end. Writes\n"
         "                    cycle.json and cycle.png. With --set as it would be then.\n"
         "  --topic TOPIC     which, where several planners were recorded\n"
         "  --out DIR         where files go; default: the bag's name with _replay, in the present folder\n"
         "  --no-picture      no PNG (needs python3-matplotlib)\n"
         "\n"
         "Status: 0 all the same, 1 some differ, 2 the bag or the command line is at fault.\n";
}

}  // namespace replay
}  // namespace hidwa_local_planner
