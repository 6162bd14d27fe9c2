// SPDX-License-Identifier: BSD-3-Clause
#include "study/options.hpp"

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <utility>

#include "core/util/words.hpp"
#include "study/attack_table.hpp"
#include "study/barn_drive.hpp"
#include "study/dynabarn_drive.hpp"
#include "study/error.hpp"
#include "study/gap_drive.hpp"

namespace hidwa_local_planner {
namespace study {
namespace {

std::uint64_t whole_number(const std::string& option, const std::string& text, std::uint64_t least,
                           std::uint64_t greatest) {
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

// "first, second and third", with `last` between the two last ones.
std::string in_words(const std::vector<std::string>& parts, const std::string& last) {
  std::string all;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    all += (k == 0 ? "" : k + 1 == parts.size() ? last : ", ") + parts[k];
  }
  return all;
}

// Takes what is given to an option of this name.
using Reader = std::function<void(Options& options, const std::string& name, const std::string& text)>;

Reader text(std::string Options::*member) {
  return [member](Options& o, const std::string&, const std::string& text) { o.*member = text; };
}

// Each time that the option is there.
Reader texts(std::vector<std::string> Options::*member) {
  return [member](Options& o, const std::string&, const std::string& text) { (o.*member).push_back(text); };
}

// An option without a value.
Reader turned(bool Options::*member, bool value) {
  return [member, value](Options& o, const std::string&, const std::string&) { o.*member = value; };
}

template <typename Number>
Reader whole(Number Options::*member, std::uint64_t least, std::uint64_t greatest) {
  return [member, least, greatest](Options& o, const std::string& name, const std::string& text) {
    o.*member = static_cast<Number>(whole_number(name, text, least, greatest));
  };
}

Reader number(double Options::*member, double least, double greatest) {
  return [member, least, greatest](Options& o, const std::string& name, const std::string& text) {
    o.*member = number_within(name, text, least, greatest);
  };
}

Reader pose(std::optional<sim::Pose> Options::*member) {
  return [member](Options& o, const std::string& name, const std::string& text) {
    const std::vector<std::string> parts = list(text);
    std::vector<double> numbers;
    for (const std::string& part : parts) {
      if (const std::optional<double> number = number_in(part)) numbers.push_back(*number);
    }
    if (parts.size() != 3 || numbers.size() != 3)
      throw UsageError(name + " needs x,y,yaw in metres and radians, not '" + text + "'");
    o.*member = sim::Pose{numbers[0], numbers[1], numbers[2]};
  };
}

// One of these words, each with what it stands for.
template <typename Value>
Reader one_of(Value Options::*member, const std::vector<std::pair<std::string, Value>>& choices) {
  return [member, choices](Options& o, const std::string& name, const std::string& text) {
    std::vector<std::string> words;
    for (const auto& [word, value] : choices) {
      words.push_back(word);
      if (word != text) continue;
      o.*member = value;
      return;
    }
    throw UsageError(name + " is " + in_words(words, " or ") + ", not '" + text + "'");
  };
}

// Some of these words, each with the names for which it stands. `listed`: the words as a fault lists them.
Reader some_of(std::vector<std::string> Options::*member,
               const std::map<std::string, std::vector<std::string>>& choices, const std::string& listed) {
  return [member, choices, listed](Options& o, const std::string& name, const std::string& text) {
    const auto fault = [&](const std::string& word) {
      return UsageError(name + " knows no '" + word + "': it needs some of " + listed);
    };
    std::set<std::string> names;
    for (const std::string& word : list(text)) {
      const auto choice = choices.find(word);
      if (choice == choices.end()) throw fault(word);
      names.insert(choice->second.begin(), choice->second.end());
    }
    if (names.empty()) throw fault(text);
    (o.*member).assign(names.begin(), names.end());
  };
}

// Words that stand for themselves.
Reader some_of(std::vector<std::string> Options::*member, const std::vector<std::string>& words) {
  std::map<std::string, std::vector<std::string>> choices;
  for (const std::string& word : words) choices[word] = {word};
  return some_of(member, choices, to_line(words));
}

void read_set(Options& options, const std::string&, const std::string& text) {
  options.sets.push_back(parse_assignment(text));
}

void read_shard(Options& options, const std::string& name, const std::string& text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos) throw UsageError(name + " needs K/N, such as 1/8, not '" + text + "'");
  options.shards = whole_number(name, text.substr(slash + 1), 1, 1000000);
  options.shard = whole_number(name, text.substr(0, slash), 1, options.shards);
}

struct Option {
  std::string name;
  std::string commands;  // that it is for, with blanks between them; empty: all
  std::string value;     // what --help calls its value; empty: it takes none
  Reader read;
  std::optional<std::string> help;  // none: not among the options that --help lists
};

const char* const kPeople = "run pilot sweep";
const char* const kFloor = "run pilot sweep crowd passage";
const char* const kVaried = "sweep barn dynabarn crowd passage gap";  // for one value there is --set
const char* const kSet = "run pilot sweep barn dynabarn crowd passage gap";
const std::uint64_t kGreatest = 999999999999ULL;

// In the order of --help.
const std::vector<Option> kOptions{
    {"--out", "", "DIR", text(&Options::out), std::nullopt},
    {"--grid", kVaried, "NAME=V1,V2,...", texts(&Options::grid), std::nullopt},
    {"--vary", kVaried, "NAME=V1,V2,...", texts(&Options::vary), std::nullopt},
    {"--worlds", "barn dynabarn attack", "FILE", text(&Options::worlds), std::nullopt},
    {"--map", "run pilot sweep crowd passage attack", "FILE.yaml", text(&Options::map),
     "the map; default: the package's office; attack: further ones for mixed drives, with commas between them"},
    {"--regions", kFloor, "FILE.yaml", text(&Options::regions),
     "regions to avoid, with start and goal; none: no regions"},
    {"--start", kFloor, "X,Y,YAW", pose(&Options::start), "[m, m, rad]; default: the regions file's"},
    {"--goal", kFloor, "X,Y,YAW", pose(&Options::goal), ""},
    {"--participants", kPeople, "N", whole(&Options::participants, 1, 9999), ""},
    {"--conditions", kPeople, "SJ,SG,SW", some_of(&Options::conditions, std::vector<std::string>{"SJ", "SG", "SW"}),
     "some of them"},
    {"--mode", "barn dynabarn crowd", "AUTONOMY,HELPFUL,HOSTILE,AFTERMATH",
     some_of(&Options::modes,
             {{"AUTONOMY", {"AUTONOMY"}},
              {"HELPFUL", {"HELPFUL"}},
              {"HOSTILE", {"HOSTILE"}},
              {"AFTERMATH", {"AFTERMATH"}},
              {"SHARED", {"HELPFUL", "HOSTILE"}}},
             "AUTONOMY,HELPFUL,HOSTILE,AFTERMATH (SHARED: HELPFUL,HOSTILE)"),
     "barn, dynabarn, crowd: some of them; SHARED: HELPFUL and HOSTILE; AFTERMATH: barn only;\n"
     "default: all but AFTERMATH"},
    {"--tracking", "dynabarn crowd", "none|truth|laser",
     one_of(&Options::tracking,
            {{"none", drive::Tracking::none}, {"truth", drive::Tracking::truth}, {"laser", drive::Tracking::laser}}),
     "dynabarn, crowd: what the planner is told of what moves: nothing, its true states (default), or\n"
     "what the tracker makes of the scans"},
    {"--seeds", "dynabarn crowd passage", "N", whole(&Options::seeds, 1, 9999),
     "dynabarn: drives in each world and mode; crowd: drives in each mode; passage: drives;\n"
     "default 10"},
    {"--outline", "gap", "circle,square,long", some_of(&Options::outlines, gap_outlines()),
     "gap: some of them; default all"},
    {"--phases", "gap", "N", whole(&Options::phases, 1, 1000),
     "gap: places on the grid, of each outline and setting; default 8"},
    {"--motion", "dynabarn", "linear|spline",
     one_of(&Options::motion, {{"linear", sim::KeyMotion::linear}, {"spline", sim::KeyMotion::spline}}),
     "dynabarn: between key frames; default linear"},
    {"--speed", "dynabarn", "V", number(&Options::speed, 0.1, 2.0),
     "dynabarn: max_vel_x, and the most that it drives backwards [m/s]; default 2.0"},
    {"--people", "crowd", "N", whole(&Options::people, 0, 200), "crowd; default 20"},
    {"--yielding", "crowd", "SHARE", number(&Options::yielding, 0.0, 1.0),
     "crowd: of the people, who keep away from the robot; the others do not mind it; default 0.5"},
    {"--condition", "attack", "NAME,...", some_of(&Options::conditions, attack_conditions()),
     "attack: some of them; default all but mixed"},
    {"--list", "attack", "", turned(&Options::list, true), "attack: only tell the conditions, and what each is"},
    {"--drives", "attack", "N", whole(&Options::drives, 1, 9999999), "attack: of each condition; default 300"},
    {"--seconds", "attack", "N", whole(&Options::seconds, 1, 3600), "attack: of each drive; default 20"},
    {"--drive", "attack", "N", whole(&Options::drive, 0, 9999999),
     "attack: of one condition this drive alone, with what happened every 10 ms in trace.csv"},
    {"--seed", "", "N", whole(&Options::seed, 0, kGreatest), "of everything random; default 1"},
    {"--profile", kPeople, "default|paper", one_of(&Options::profile, {{"default", "default"}, {"paper", "paper"}}),
     ""},
    {"--guard", kPeople, "none|nearest", one_of(&Options::guard, {{"none", Guard::none}, {"nearest", Guard::nearest}}),
     "SW: the person's own velocity (default, the paper's), or the nearest legal one"},
    {"--set", kSet, "NAME=VALUE", read_set,
     "a parameter of the planner (docs/use/parameters.md), participant.TRAIT (docs/use/study.md), or\n"
     "link_delay [s]; barn, dynabarn: also costmap.NAME; gap: also costmap.resolution,\n"
     "costmap.footprint_padding and laser.noise; may be repeated"},
    {"--threads", "", "N", whole(&Options::threads, 1, 1024), "default: as many as there are cores"},
    {"--shard", "", "K/N", read_shard, "the K-th of N parts only"},
    {"--resume", "", "", turned(&Options::resume, true), std::nullopt},
    {"--no-resume", "", "", turned(&Options::resume, false), "make runs again that are finished; default: keep them"},
    {"--paths", "", "", turned(&Options::paths, true), std::nullopt},
    {"--no-paths", "", "", turned(&Options::paths, false), "do not keep the ways driven"}};

// Options that say nothing to a command are refused: whoever gives them expects something else.
void check_command(const Option& option, const std::string& command) {
  const std::vector<std::string> commands = split(option.commands, ' ');
  if (option.commands.empty() || std::count(commands.begin(), commands.end(), command) > 0) return;
  throw UsageError(option.name + " is for " + in_words(commands, " and ") + ": see hidwa_study --help");
}

void read_arguments(const std::vector<std::string>& arguments, Options& options) {
  for (std::size_t i = 1; i < arguments.size(); ++i) {
    std::string name = arguments[i];
    std::optional<std::string> value;
    const std::size_t equals = name.find('=');
    if (name.compare(0, 2, "--") == 0 && equals != std::string::npos) {
      value = name.substr(equals + 1);
      name.resize(equals);
    }
    if (name == "--help" || name == "-h") {
      options.command = "help";
      return;
    }
    const auto option =
        std::find_if(kOptions.begin(), kOptions.end(), [&name](const Option& other) { return other.name == name; });
    if (option != kOptions.end()) {
      check_command(*option, options.command);
      const bool takes_one = !option->value.empty();
      if (value && !takes_one) throw UsageError(name + " takes no value: see hidwa_study --help");
      if (!value && takes_one) {
        if (i + 1 == arguments.size()) throw UsageError(name + " needs a value: see hidwa_study --help");
        value = arguments[++i];
      }
      option->read(options, name, value.value_or(""));
    } else if (options.command == "merge" && !name.empty() && name.front() != '-') {
      options.parts.push_back(name);
    } else {
      throw UsageError("there is no option '" + name + "': see hidwa_study --help");
    }
  }
}

void check(const Options& o) {
  if (o.command == "help" || o.list) return;
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
  if (o.drive && o.conditions.size() != 1) throw UsageError("--drive needs one --condition");
  const bool mixed = std::count(o.conditions.begin(), o.conditions.end(), kMixed) > 0;
  if (mixed && o.conditions.size() > 1) {
    throw UsageError("--condition mixed stands alone: it takes the conditions in turn");
  }
  if (o.command == "attack" && !mixed && !(o.map.empty() && o.worlds.empty())) {
    throw UsageError("attack takes --map and --worlds with --condition mixed alone");
  }
  if (!o.grid.empty() && !o.vary.empty()) throw UsageError(o.command + " takes --grid or --vary, not both");
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
  hidwa_study attack --out DIR [--condition NAME,...] [--drives N]
                                people who want a collision, faulty odometry, late cycles and bases of all kinds, one
                                condition after the other; ends with 1 where something within the promise was found
                                (docs/evidence/attack.md)
  hidwa_study attack --out DIR --condition mixed --drives N [--map FILE,FILE] [--worlds FILE]
                                conditions in turn, also in the office, on these maps and in BARN fields
  hidwa_study passage --out DIR --start X,Y,YAW --goal X,Y,YAW
                                the demo's robot alone through a tight place, and how steadily (docs/evidence/ways.md)
  hidwa_study gap --out DIR     the narrowest gap that a robot gets through, by cells, noise, outline and where the gap
                                lies on the grid (docs/evidence/ways.md)
  hidwa_study merge --out DIR PART...
                                joins what was made with --shard

)";
}

// Name and value, and from a column on what there is to be said of them.
std::string help_of(const Option& option) {
  const std::string name = "  " + option.name + (option.value.empty() ? "" : " ") + option.value;
  if (option.help->empty()) return name + '\n';
  std::string lines = name.size() < 26 ? "" : name + '\n';
  for (const std::string& line : split(*option.help, '\n')) {
    lines += format("%-26s", lines.empty() ? name.c_str() : "") + line + '\n';
  }
  return lines;
}

std::string options_help() {
  std::string all;
  for (const Option& option : kOptions) {
    if (option.help) all += help_of(option);
  }
  return all + R"(
In DIR: runs.csv, summary.json, ranking.csv (several settings), paths/, timing.json, trace.csv (attack --drive).
Ends with 0; 1 where a run could not be made, or an attack found something within the promise; 2 where the arguments
make no sense.
)";
}

}  // namespace

Options parse_options(const std::vector<std::string>& arguments) {
  Options options;
  options.command = arguments.empty() ? "" : arguments.front();
  if (options.command == "--help" || options.command == "-h") options.command = "help";
  const std::vector<std::string> commands{"run",   "pilot",   "sweep", "barn",   "dynabarn",
                                          "crowd", "passage", "gap",   "attack", "merge"};
  if (options.command != "help" && std::count(commands.begin(), commands.end(), options.command) == 0) {
    throw UsageError((options.command.empty() ? "what to do is missing" : "'" + options.command + "' is unknown") +
                     ": hidwa_study " + in_words(commands, " or ") + "; see hidwa_study --help");
  }
  if (options.command == "pilot" || options.command == "sweep") {
    options.participants = 8;
    options.conditions = {"SJ"};
  }
  if (options.command == "attack") {
    options.conditions = attack_conditions();
    options.conditions.pop_back();  // mixed is for those who ask for it
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
