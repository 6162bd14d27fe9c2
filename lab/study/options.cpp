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
#include "study/dynabarn_drive.hpp"
#include "study/error.hpp"
#include "study/gap_drive.hpp"

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

double number_within(const std::string& option, const std::string& text, double least, double greatest) {
  const std::optional<double> value = number_in(text);
  if (!value || *value < least || *value > greatest) {
    throw UsageError(option + " needs a number from " + shortest(least) + " to " + shortest(greatest) + ", not '" +
                     text + "'");
  }
  return *value;
}

std::vector<std::string> outlines(const std::string& text) {
  std::vector<std::string> names;
  for (const std::string& name : list(text)) {
    if (std::count(gap_outlines().begin(), gap_outlines().end(), name) == 0) {
      throw UsageError("--outline needs some of circle,square,long, not '" + text + "'");
    }
    if (std::count(names.begin(), names.end(), name) == 0) names.push_back(name);
  }
  if (names.empty()) throw UsageError("--outline needs some of circle,square,long");
  return names;
}

drive::Tracking tracking(const std::string& text) {
  if (text == "none") return drive::Tracking::none;
  if (text == "truth") return drive::Tracking::truth;
  if (text == "laser") return drive::Tracking::laser;
  throw UsageError("--tracking is none, truth or laser, not '" + text + "'");
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
      {"--tracking", [&o](const std::string& v) { o.tracking = tracking(v); }},
      {"--motion",
       [&o](const std::string& v) {
         o.motion =
             one_of("--motion", v, "linear", "spline") == "linear" ? sim::KeyMotion::linear : sim::KeyMotion::spline;
       }},
      {"--speed", [&o](const std::string& v) { o.speed = number_within("--speed", v, 0.1, 2.0); }},
      {"--seeds", [&o](const std::string& v) { o.seeds = static_cast<int>(whole("--seeds", v, 1, 9999)); }},
      {"--outline", [&o](const std::string& v) { o.outlines = outlines(v); }},
      {"--phases", [&o](const std::string& v) { o.phases = static_cast<int>(whole("--phases", v, 1, 1000)); }},
      {"--people", [&o](const std::string& v) { o.people = static_cast<int>(whole("--people", v, 0, 200)); }},
      {"--yielding", [&o](const std::string& v) { o.yielding = number_within("--yielding", v, 0.0, 1.0); }},
      {"--cycles", [&o](const std::string& v) { o.cycles = whole("--cycles", v, 1, 999999999999ULL); }},
      {"--hours", [&o](const std::string& v) { o.hours = number_within("--hours", v, 0.01, 1000.0); }},
      {"--drive", [&o](const std::string& v) { o.drive = whole("--drive", v, 0, 999999999999ULL); }},
      {"--shard", [&o](const std::string& v) { read_shard(v, o); }},
  };
}

std::map<std::string, std::function<void()>> switches(Options& o) {
  return {{"--resume", [&o] { o.resume = true; }},
          {"--no-resume", [&o] { o.resume = false; }},
          {"--paths", [&o] { o.paths = true; }},
          {"--no-paths", [&o] { o.paths = false; }}};
}

// The commands that an option is for; empty: for all.
std::vector<std::string> commands_of(const std::string& name) {
  const std::vector<std::string> study{"run", "pilot", "sweep"}, floor{"run", "pilot", "sweep", "crowd", "passage"};
  const std::vector<std::string> maps{"run", "pilot", "sweep", "crowd", "passage", "hostile"};
  const std::map<std::string, std::vector<std::string>> of{{"--map", maps},
                                                           {"--regions", floor},
                                                           {"--start", floor},
                                                           {"--goal", floor},
                                                           {"--participants", study},
                                                           {"--conditions", study},
                                                           {"--profile", study},
                                                           {"--guard", study},
                                                           {"--worlds", {"barn", "dynabarn", "hostile"}},
                                                           {"--mode", {"barn", "dynabarn", "crowd"}},
                                                           {"--tracking", {"dynabarn", "crowd"}},
                                                           {"--seeds", {"dynabarn", "crowd", "passage"}},
                                                           {"--outline", {"gap"}},
                                                           {"--phases", {"gap"}},
                                                           {"--motion", {"dynabarn"}},
                                                           {"--speed", {"dynabarn"}},
                                                           {"--people", {"crowd"}},
                                                           {"--cycles", {"hostile"}},
                                                           {"--drive", {"hostile"}},
                                                           {"--hours", {"soak"}},
                                                           {"--yielding", {"crowd"}}};
  const auto found = of.find(name);
  return found == of.end() ? std::vector<std::string>{} : found->second;
}

// Options that say nothing to a command are refused: whoever gives them expects something else.
void check_option(const std::string& command, const std::string& name) {
  const std::vector<std::string> commands = commands_of(name);
  if (commands.empty() || std::count(commands.begin(), commands.end(), command) > 0) return;
  std::string all;
  for (std::size_t k = 0; k < commands.size(); ++k) {
    all += (k == 0 ? "" : k + 1 == commands.size() ? " and " : ", ") + commands[k];
  }
  throw UsageError(name + " is for " + all + ": see hidwa_study --help");
}

void read_arguments(const std::vector<std::string>& arguments, Options& options) {
  const std::map<std::string, Reader> with_value = readers(options);
  const std::map<std::string, std::function<void()>> without = switches(options);
  for (std::size_t i = 1; i < arguments.size(); ++i) {
    std::string name = arguments[i];
    std::optional<std::string> joined;  // --name=value
    const std::size_t equals = name.find('=');
    if (name.compare(0, 2, "--") == 0 && equals != std::string::npos) {
      joined = name.substr(equals + 1);
      name.resize(equals);
    }
    if (name == "--help" || name == "-h") {
      options.command = "help";
      return;
    }
    check_option(options.command, name);
    const auto reader = with_value.find(name);
    const auto toggle = without.find(name);
    if (reader != with_value.end()) {
      if (!joined && i + 1 == arguments.size()) throw UsageError(name + " needs a value: see hidwa_study --help");
      reader->second(joined ? *joined : arguments[++i]);
    } else if (toggle != without.end()) {
      if (joined) throw UsageError(name + " takes no value: see hidwa_study --help");
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
  const bool in_worlds = o.command == "barn" || o.command == "dynabarn";
  if (in_worlds && o.worlds.empty()) {
    throw UsageError(std::string("--worlds is missing: a file of ") + (o.command == "barn" ? "BARN" : "DynaBARN") +
                     " worlds");
  }
  if (o.command == "dynabarn" && o.seeds > kSeedsOfWorld) {
    throw UsageError("--seeds is at most " + std::to_string(kSeedsOfWorld) + " for dynabarn");
  }
  if (o.command != "barn" && std::count(o.modes.begin(), o.modes.end(), "AFTERMATH") > 0) {
    throw UsageError("--mode AFTERMATH is for barn: take some of AUTONOMY,HELPFUL,HOSTILE");
  }
  const std::vector<std::string> varied{"sweep", "barn", "dynabarn", "crowd", "passage", "gap"};
  const bool several = std::count(varied.begin(), varied.end(), o.command) > 0;
  if (several && o.command != "sweep" && !o.grid.empty() && !o.vary.empty())
    throw UsageError(o.command + " takes --grid or --vary, not both");
  if (!several && !o.grid.empty())
    throw UsageError("--grid is for sweep, barn, dynabarn, crowd, passage and gap; for one value take --set");
  if (!several && !o.vary.empty())
    throw UsageError("--vary is for sweep, barn, dynabarn, crowd, passage and gap; for one value take --set");
  if (o.command == "pilot") {
    for (const Assignment& set : o.sets) {
      if (set.name == "s_v" || set.name == "s_omega" || set.name == "delta") {
        throw UsageError("pilot sets " + set.name + " itself: take sweep --grid for other values");
      }
    }
  }
}

std::string commands_help() {
  return R"(hidwa_study: simulated people steer the simulated robot; the same arguments give the same results.

  hidwa_study run   --out DIR   conditions SJ, SG and SW, 32 participants
  hidwa_study pilot --out DIR   SJ with the paper's four combinations of s_v, s_omega and delta, 8 participants
  hidwa_study sweep --out DIR --grid NAME=V1,V2,... [--grid ...]
                                every combination, 8 participants, SJ
  hidwa_study sweep --out DIR --vary NAME=V1,V2,... [--vary ...]
                                as it is, then each value alone: the sensitivity to it
  hidwa_study barn --out DIR --worlds FILE
                                BARN-2D: a Jackal in fields of cylinders, alone and with a person (docs/use/study.md)
  hidwa_study dynabarn --out DIR --worlds FILE
                                DynaBARN-2D: a Jackal through courts that cylinders cross (docs/use/study.md)
  hidwa_study crowd --out DIR   the demo's robot and route among people who walk around
  hidwa_study hostile --out DIR --cycles N [--map FILE,FILE] [--worlds FILE]
                                people who want a collision, in the office, on these maps, in BARN fields and in drawn
                                scenes; ends with 1 where something within the promise was found
                                (docs/evidence/attack.md)
  hidwa_study soak --out DIR [--hours H]
                                one planner for hours of simulated time: memory, cycle time, states
                                (docs/evidence/attack.md)
  hidwa_study passage --out DIR --start X,Y,YAW --goal X,Y,YAW
                                the demo's robot alone through a tight place, and how steadily (docs/evidence/ways.md)
  hidwa_study gap --out DIR     the narrowest gap that a robot gets through, by cells, noise, outline and where the gap
                                lies on the grid (docs/evidence/ways.md)
  hidwa_study merge --out DIR PART...
                                joins what was made with --shard

)";
}

std::string options_help() {
  return R"(  --map FILE.yaml         the map; default: the package's office
  --regions FILE.yaml     regions to avoid, with start and goal; none: no regions
  --start X,Y,YAW         [m, m, rad]; default: the regions file's
  --goal X,Y,YAW
  --participants N
  --conditions SJ,SG,SW   some of them
  --mode AUTONOMY,HELPFUL,HOSTILE,AFTERMATH
                          barn, dynabarn, crowd: some of them; SHARED: HELPFUL and HOSTILE; AFTERMATH: barn only;
                          default: all but AFTERMATH
  --tracking none|truth|laser
                          dynabarn, crowd: what the planner is told of what moves: nothing, its true states (default), or
                          what the tracker makes of the scans
  --seeds N               dynabarn: drives in each world and mode; crowd: drives in each mode; passage: drives;
                          default 10
  --outline circle,square,long
                          gap: some of them; default all
  --phases N              gap: places on the grid, of each outline and setting; default 8
  --motion linear|spline  dynabarn: between key frames; default linear
  --speed V               dynabarn: max_vel_x, and the most that it drives backwards [m/s]; default 2.0
  --people N              crowd; default 20
  --yielding SHARE        crowd: of the people, who keep away from the robot; the others do not mind it; default 0.5
  --hours H               soak: simulated; default 1
  --cycles N              hostile: control cycles, at least; default 100000
  --drive N               hostile: this drive alone, with what happened every 10 ms in a file
  --seed N                of everything random; default 1
  --profile default|paper
  --guard none|nearest    SW: the person's own velocity (default, the paper's), or the nearest legal one
  --set NAME=VALUE        a parameter of the planner (docs/use/parameters.md), participant.TRAIT (docs/use/study.md), or
                          link_delay [s]; barn, dynabarn: also costmap.NAME; gap: also costmap.resolution,
                          costmap.footprint_padding and laser.noise; may be repeated
  --threads N             default: as many as there are cores
  --shard K/N             the K-th of N parts only
  --no-resume             make runs again that are finished; default: keep them
  --no-paths              do not keep the ways driven

In DIR: runs.csv, summary.json, ranking.csv (several settings), paths/, timing.json.
Ends with 0; 1 where a run could not be made; 2 where the arguments make no sense.
)";
}

}  // namespace

Options parse_options(const std::vector<std::string>& arguments) {
  Options options;
  options.command = arguments.empty() ? "" : arguments.front();
  if (options.command == "--help" || options.command == "-h") options.command = "help";
  const std::vector<std::string> commands{"run",     "pilot", "sweep",   "barn", "dynabarn", "crowd",
                                          "passage", "gap",   "hostile", "soak", "merge",    "help"};
  if (std::count(commands.begin(), commands.end(), options.command) == 0) {
    throw UsageError((options.command.empty() ? "what to do is missing" : "'" + options.command + "' is unknown") +
                     std::string(": hidwa_study run, pilot, sweep, barn, dynabarn, crowd, passage, gap, hostile, soak "
                                 "or merge; see hidwa_study "
                                 "--help"));
  }
  if (options.command == "pilot" || options.command == "sweep") {
    options.participants = 8;
    options.conditions = {"SJ"};
  }
  options.modes = usual_barn_modes();
  options.outlines = gap_outlines();
  read_arguments(arguments, options);
  check(options);
  return options;
}

std::vector<Setting> settings_of(const Options& options) {
  return options.vary.empty() ? combinations(options.grid) : variations(options.vary);
}

std::string help() { return commands_help() + options_help(); }

}  // namespace study
}  // namespace hidwa_local_planner
