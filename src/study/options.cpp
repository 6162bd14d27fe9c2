// SPDX-License-Identifier: BSD-3-Clause
#include "study/options.hpp"

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <map>
#include <optional>
#include <sstream>

#include "core/util/words.hpp"
#include "study/barn_drive.hpp"
#include "study/error.hpp"

namespace hidwa_local_planner {
namespace study {
namespace {

std::uint64_t whole(const std::string& option, const std::string& text, std::uint64_t least, std::uint64_t greatest) {
  const bool digits = !text.empty() && text.size() < 19 && text.find_first_not_of("0123456789") == std::string::npos;
  const std::uint64_t value = digits ? std::strtoull(text.c_str(), nullptr, 10) : 0;
  if (!digits || value < least || value > greatest) {
    throw UsageError(option + " needs a whole number from " + std::to_string(least) + " to " +
                     std::to_string(greatest) + ", not '" + text + "'");
  }
  return value;
}

std::vector<std::string> list(const std::string& text) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ',');) parts.push_back(part);
  return parts;
}

sim::Pose pose(const std::string& option, const std::string& text) {
  const std::vector<std::string> parts = list(text);
  std::vector<double> numbers;
  for (const std::string& part : parts) {
    if (const std::optional<double> number = number_in(part)) numbers.push_back(*number);
  }
  if (parts.size() != 3 || numbers.size() != 3)
    throw UsageError(option + " needs x,y,yaw in metres and radians, not '" + text + "'");
  return {numbers[0], numbers[1], numbers[2]};
}

std::vector<std::string> conditions(const std::string& text) {
  std::vector<std::string> names = list(text);
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  const bool known = std::all_of(names.begin(), names.end(),
                                 [](const std::string& name) { return name == "SJ" || name == "SG" || name == "SW"; });
  if (names.empty() || !known) throw UsageError("--conditions needs some of SJ,SG,SW, not '" + text + "'");
  return names;
}

std::vector<std::string> modes(const std::string& text) {
  std::vector<std::string> names;
  for (const std::string& name : list(text)) {
    if (name == "SHARED") {
      names.insert(names.end(), {"HELPFUL", "HOSTILE"});
    } else if (std::count(barn_modes().begin(), barn_modes().end(), name) > 0) {
      names.push_back(name);
    } else {
      names.clear();
      break;
    }
  }
  if (names.empty()) {
    throw UsageError("--mode needs some of AUTONOMY,HELPFUL,HOSTILE,AFTERMATH (SHARED: HELPFUL,HOSTILE), not '" + text +
                     "'");
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

std::string one_of(const std::string& option, const std::string& text, const std::string& a, const std::string& b) {
  if (text != a && text != b) throw UsageError(option + " is " + a + " or " + b + ", not '" + text + "'");
  return text;
}

void read_shard(const std::string& text, Options& options) {
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos) throw UsageError("--shard needs K/N, such as 1/8, not '" + text + "'");
  options.shards = whole("--shard", text.substr(slash + 1), 1, 1000000);
  options.shard = whole("--shard", text.substr(0, slash), 1, options.shards);
}

using Reader = std::function<void(const std::string&)>;

std::map<std::string, Reader> readers(Options& o) {
  return {
      {"--out", [&o](const std::string& v) { o.out = v; }},
      {"--map", [&o](const std::string& v) { o.map = v; }},
      {"--regions", [&o](const std::string& v) { o.regions = v; }},
      {"--start", [&o](const std::string& v) { o.start = pose("--start", v); }},
      {"--goal", [&o](const std::string& v) { o.goal = pose("--goal", v); }},
      {"--participants",
       [&o](const std::string& v) { o.participants = static_cast<int>(whole("--participants", v, 1, 9999)); }},
      {"--conditions", [&o](const std::string& v) { o.conditions = conditions(v); }},
      {"--seed", [&o](const std::string& v) { o.seed = whole("--seed", v, 0, 999999999999ULL); }},
      {"--threads", [&o](const std::string& v) { o.threads = whole("--threads", v, 1, 1024); }},
      {"--profile", [&o](const std::string& v) { o.profile = one_of("--profile", v, "default", "paper"); }},
      {"--guard",
       [&o](const std::string& v) {
         o.guard = one_of("--guard", v, "none", "nearest") == "none" ? Guard::none : Guard::nearest;
       }},
      {"--set", [&o](const std::string& v) { o.sets.push_back(parse_assignment(v)); }},
      {"--grid", [&o](const std::string& v) { o.grid.push_back(v); }},
      {"--vary", [&o](const std::string& v) { o.vary.push_back(v); }},
      {"--worlds", [&o](const std::string& v) { o.worlds = v; }},
      {"--mode", [&o](const std::string& v) { o.modes = modes(v); }},
      {"--shard", [&o](const std::string& v) { read_shard(v, o); }},
  };
}

std::map<std::string, std::function<void()>> switches(Options& o) {
  return {{"--resume", [&o] { o.resume = true; }},
          {"--no-resume", [&o] { o.resume = false; }},
          {"--paths", [&o] { o.paths = true; }},
          {"--no-paths", [&o] { o.paths = false; }}};
}

// Options that say nothing to a command are refused: whoever gives them expects something else.
void check_option(const std::string& command, const std::string& name) {
  const std::vector<std::string> of_barn{"--worlds", "--mode"};
  const std::vector<std::string> of_people{"--map",          "--regions",    "--start",   "--goal",
                                           "--participants", "--conditions", "--profile", "--guard"};
  const bool barn = command == "barn";
  const std::vector<std::string>& others = barn ? of_people : of_barn;
  if (std::count(others.begin(), others.end(), name) > 0) {
    throw UsageError(name + " is for " + (barn ? "run, pilot and sweep" : "barn") + ": see hidwa_study --help");
  }
}

void read_arguments(const std::vector<std::string>& arguments, Options& options) {
  const std::map<std::string, Reader> with_value = readers(options);
  const std::map<std::string, std::function<void()>> without = switches(options);
  for (std::size_t i = 1; i < arguments.size(); ++i) {
    const std::string& name = arguments[i];
    if (name == "--help" || name == "-h") {
      options.command = "help";
      return;
    }
    check_option(options.command, name);
    const auto reader = with_value.find(name);
    const auto toggle = without.find(name);
    if (reader != with_value.end()) {
      if (i + 1 == arguments.size()) throw UsageError(name + " needs a value: see hidwa_study --help");
      reader->second(arguments[++i]);
    } else if (toggle != without.end()) {
      toggle->second();
    } else if (options.command == "merge" && !name.empty() && name.front() != '-') {
      options.parts.push_back(name);
    } else {
      throw UsageError("there is no option '" + name + "': see hidwa_study --help");
    }
  }
}

void check(const Options& o) {
  if (o.command == "help") return;
  if (o.out.empty()) throw UsageError("--out is missing: the folder for the results");
  if (o.command == "merge" && o.parts.empty()) {
    throw UsageError("merge needs the folders of the parts after its options");
  }
  if (o.command == "sweep" && o.grid.empty() == o.vary.empty()) {
    throw UsageError("sweep needs either --grid or --vary name=value,value,...");
  }
  if (o.command == "barn" && o.worlds.empty()) throw UsageError("--worlds is missing: a file of BARN worlds");
  if (o.command == "barn" && !o.grid.empty() && !o.vary.empty())
    throw UsageError("barn takes --grid or --vary, not both");
  const bool several = o.command == "sweep" || o.command == "barn";
  if (!several && !o.grid.empty()) throw UsageError("--grid is for sweep and barn; for one value take --set");
  if (!several && !o.vary.empty()) throw UsageError("--vary is for sweep and barn; for one value take --set");
  if (o.command == "pilot") {
    for (const Assignment& set : o.sets) {
      if (set.name == "s_v" || set.name == "s_omega" || set.name == "delta") {
        throw UsageError("pilot sets " + set.name + " itself: take sweep --grid for other values");
      }
    }
  }
}

}  // namespace

Options parse_options(const std::vector<std::string>& arguments) {
  Options options;
  options.command = arguments.empty() ? "" : arguments.front();
  if (options.command == "--help" || options.command == "-h") options.command = "help";
  const std::vector<std::string> commands{"run", "pilot", "sweep", "barn", "merge", "help"};
  if (std::count(commands.begin(), commands.end(), options.command) == 0) {
    throw UsageError((options.command.empty() ? "what to do is missing" : "'" + options.command + "' is unknown") +
                     std::string(": hidwa_study run, pilot, sweep, barn or merge; see hidwa_study --help"));
  }
  if (options.command == "pilot" || options.command == "sweep") {
    options.participants = 8;
    options.conditions = {"SJ"};
  }
  options.modes = usual_barn_modes();
  read_arguments(arguments, options);
  check(options);
  return options;
}

std::string help() {
  return R"(hidwa_study: simulated people steer the simulated robot; the same arguments give the same results.

  hidwa_study run   --out DIR   conditions SJ, SG and SW, 32 participants
  hidwa_study pilot --out DIR   SJ with the paper's four combinations of s_v, s_omega and delta, 8 participants
  hidwa_study sweep --out DIR --grid NAME=V1,V2,... [--grid ...]
                                every combination, 8 participants, SJ
  hidwa_study sweep --out DIR --vary NAME=V1,V2,... [--vary ...]
                                as it is, then each value alone: the sensitivity to it
  hidwa_study barn --out DIR --worlds FILE
                                BARN-2D: a Jackal in fields of cylinders, alone and with a person (docs/study.md)
  hidwa_study merge --out DIR PART...
                                joins what was made with --shard

  --map FILE.yaml         the map; default: the package's office
  --regions FILE.yaml     regions to avoid, with start and goal; none: no regions
  --start X,Y,YAW         [m, m, rad]; default: the regions file's
  --goal X,Y,YAW
  --participants N
  --conditions SJ,SG,SW   some of them
  --mode AUTONOMY,HELPFUL,HOSTILE,AFTERMATH
                          barn: some of them; SHARED: HELPFUL and HOSTILE;
                          default: all but AFTERMATH
  --seed N                of everything random; default 1
  --profile default|paper
  --guard none|nearest    SW: the person's own velocity (default, the paper's), or the nearest legal one
  --set NAME=VALUE        a parameter of the planner (docs/parameters.md), participant.TRAIT (see docs/study.md), or
                          link_delay [s]; barn: also costmap.NAME; may be repeated
  --threads N             default: as many as there are cores
  --shard K/N             the K-th of N parts only
  --no-resume             make runs again that are finished; default: keep them
  --no-paths              do not keep the ways driven

In DIR: runs.csv, summary.json, ranking.csv (several settings), paths/, timing.json.
Ends with 0; 1 where a run could not be made; 2 where the arguments make no sense.
)";
}

}  // namespace study
}  // namespace hidwa_local_planner
