// SPDX-License-Identifier: BSD-3-Clause
#include "hidwa_local_planner/study/program.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <fstream>
#include <mutex>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "hidwa_local_planner/study/error.hpp"
#include "hidwa_local_planner/study/options.hpp"
#include "hidwa_local_planner/study/runner.hpp"
#include "hidwa_local_planner/study/scene.hpp"
#include "hidwa_local_planner/study/seed.hpp"
#include "hidwa_local_planner/study/store.hpp"
#include "hidwa_local_planner/study/summary.hpp"
#include "progress.hpp"
#include "share.hpp"

namespace hidwa_local_planner {
namespace study {
namespace {

// Fits 2^53, so that every reader of CSV takes it for the same number.
constexpr std::uint64_t kSeeds = 1000000000ULL;

// What a map or regions file says, so that another file of the same name is another study (FNV-1a).
std::string fingerprint(const std::string& path) {
  if (path == "none") return "none";
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char c : text.str()) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
  char digits[24];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash));
  return digits;
}

std::string fingerprint(const sim::OccupancyMap& map) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const sim::Cell cell : map.cells) hash = (hash ^ static_cast<std::uint64_t>(cell)) * 0x100000001b3ULL;
  char text[120];
  std::snprintf(text, sizeof text, "%d x %d, %.4f m, %.4f %.4f, %016llx", map.width, map.height, map.resolution,
                map.origin_x, map.origin_y, static_cast<unsigned long long>(hash));
  return text;
}

std::string quoted(const std::string& text) {
  std::string json = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') json += '\\';
    json += c;
  }
  return json + '"';
}

std::string pose_json(const sim::Pose& pose) {
  return "[" + number(pose.x) + ", " + number(pose.y) + ", " + number(pose.theta) + "]";
}

void fill_in(Options& options) {
  if (options.regions.empty()) {
    options.regions = options.map.empty() ? share_file("maps/office_regions.yaml") : "none";
  }
  if (options.map.empty()) options.map = share_file("maps/office.yaml");
  if (options.threads == 0) options.threads = std::max(1U, std::thread::hardware_concurrency());
}

std::string manifest(const Options& o, const Plan& plan, const Scene& scene) {
  std::string sets;
  for (const Assignment& set : o.sets) {
    sets += (sets.empty() ? "" : ", ") + quoted(set.name + "=" + set.value);
  }
  return "{\n  \"version\": " + quoted(HIDWA_VERSION) + ",\n  \"experiment\": " + quoted(plan.experiment) +
         ",\n  \"participants\": " + std::to_string(o.participants) + ",\n  \"seed\": " + std::to_string(o.seed) +
         ",\n  \"profile\": " + quoted(o.profile) +
         ",\n  \"guard\": " + quoted(o.guard == Guard::none ? "none" : "nearest") + ",\n  \"set\": [" + sets +
         "],\n  \"map\": " + quoted(fingerprint(*scene.ground->map())) +
         ",\n  \"regions\": " + quoted(fingerprint(o.regions)) + ",\n  \"start\": " + pose_json(scene.start) +
         ",\n  \"goal\": " + pose_json(scene.goal) + ",\n  \"paths\": " + (o.paths ? "true" : "false") + "\n}\n";
}

Parameters profile(const std::string& name) {
  Parameters parameters;
  assign_file(parameters, share_file("launch/params/telepresence_base.yaml"));
  if (name == "paper") assign_file(parameters, share_file("launch/params/paper.yaml"));
  return parameters;
}

Plan plan_of(const Options& options) {
  const bool pilot = options.command == "pilot";
  const std::vector<Setting> settings = pilot                   ? pilot_settings()
                                        : options.vary.empty() ? combinations(options.grid)
                                                               : variations(options.vary);
  if (settings.size() > 99999) throw UsageError("there are more than 99999 combinations: take fewer values");
  return make_plan(options.command, options.participants, options.conditions, settings, pilot);
}

/// What a participant is and what they drive, with everything set that the user set.
Subject subject_of(const Options& options, const Parameters& base, const Setting& setting,
                   const std::string& condition, int participant) {
  Subject subject;
  subject.parameters = base;
  subject.participant = draw_participant(options.seed, participant);
  for (const Assignment& set : options.sets) assign(subject, set);
  for (const Assignment& set : setting) assign(subject, set);
  subject.parameters.mode = condition == "SJ"   ? OperatorMode::joystick
                            : condition == "SG" ? OperatorMode::gesture
                                                : OperatorMode::switching;
  subject.parameters.guard = options.guard;
  return subject;
}

// Before the first run: every setting must make sense.
void check_settings(const Options& options, const Parameters& base, const Plan& plan) {
  for (const Setting& setting : plan.settings) {
    const Subject subject = subject_of(options, base, setting, options.conditions.front(), 1);
    const std::vector<std::string> faults = validate(subject.parameters);
    if (!faults.empty()) throw UsageError("setting " + to_string(setting) + ": " + faults.front());
  }
}

struct Timing {
  double simulated = 0.0;  // [s]
  double planning = 0.0;   // [s]
  std::size_t cycles = 0;
};

std::string timing_json(const Options& options, std::size_t made, std::size_t kept, double wall,
                        const Timing& timing) {
  const double cycle = timing.cycles > 0 ? timing.planning / static_cast<double>(timing.cycles) : 0.0;
  return "{\n  \"runs_made\": " + std::to_string(made) + ",\n  \"runs_kept\": " + std::to_string(kept) +
         ",\n  \"threads\": " + std::to_string(options.threads) + ",\n  \"wall_time\": " + number(wall) +
         ",\n  \"simulated_time\": " + number(timing.simulated) + ",\n  \"mean_planning_time\": " + number(cycle) +
         "\n}\n";
}

void tell(const Plan& plan, const Store& store, std::ostream& out) {
  std::vector<Row> rows;
  for (const Run& run : plan.runs) {
    if (const std::optional<Row> row = store.row(run)) rows.push_back(*row);
  }
  for (const Group& group : groups(plan, rows)) {
    double arrived = 0.0, contacts = 0.0, crossed = 0.0, duration = 0.0;
    for (const Row& row : group.rows) {
      arrived += value(row, "arrived");
      contacts += value(row, "contacts");
      crossed += value(row, "regions_crossed");
      duration += value(row, "duration");
    }
    const auto n = static_cast<double>(group.rows.size());
    char line[160];
    std::snprintf(line, sizeof line, "n %.0f, arrived %.0f, %.2f s, %.3f regions crossed, contacts %.0f in all", n,
                  arrived, duration / n, crossed / n, contacts);
    out << group.condition << " " << group.setting << ": " << line << "\n";
  }
}

int experiment(Options options, std::ostream& out, std::ostream& errors) {
  fill_in(options);
  const Plan plan = plan_of(options);
  const Parameters base = profile(options.profile);
  check_settings(options, base, plan);
  const Scene scene = load_scene(options.map, options.regions, options.start, options.goal);
  const Store store(options.out);
  store.begin(manifest(options, plan, scene), plan, options.resume);

  std::vector<Run> wanted;
  std::size_t kept = 0;
  for (const Run& run : shard(plan.runs, options.shard, options.shards)) {
    if (store.row(run)) {
      ++kept;
    } else {
      wanted.push_back(run);
    }
  }
  if (kept > 0) errors << kept << " runs are finished already and kept" << std::endl;

  Timing timing;
  std::mutex mutex;
  Progress progress(errors, wanted.size());
  const auto make = [&](const Run& run) {
    // Everybody has the same world in all conditions and settings, and their own luck in each condition.
    const std::uint64_t world = seed_for(options.seed, run.participant, "world") % kSeeds;
    const std::uint64_t person = seed_for(options.seed, run.participant, "person " + run.condition);
    const Subject subject =
        subject_of(options, base, plan.settings[run.setting], run.condition, run.participant);
    const Driven driven = drive_once(scene, subject, world, person);
    store.keep(row_of(plan, run, world, driven), options.paths ? path_csv(driven.result) : "");
    const std::lock_guard<std::mutex> lock(mutex);
    timing.simulated += driven.result.duration;
    timing.planning += driven.result.planning_time;
    timing.cycles += driven.result.cycles;
  };
  make_runs(wanted, options.threads, make, [&progress] { progress.step(); });
  store.write("timing.json", timing_json(options, wanted.size(), kept, progress.elapsed(), timing));
  const std::size_t finished = store.finish(plan);
  tell(plan, store, out);
  out << finished << " of " << plan.runs.size() << " runs: " << options.out << "/summary.json" << std::endl;
  return 0;
}

// A finished run among the parts.
struct Found {
  Row row;
  const Store* part;
};

Found find_run(const Run& run, const std::vector<Store>& parts) {
  Found found{{}, nullptr};
  for (const Store& part : parts) {
    const std::optional<Row> row = part.row(run);
    if (!row) continue;
    if (found.part != nullptr && found.row != *row) {
      throw UsageError("run " + run.id + " differs between the parts: they were made by different versions");
    }
    found = {*row, &part};
  }
  if (found.part == nullptr) {
    throw UsageError("run " + run.id + " is in none of the parts: make its shard, then merge again");
  }
  return found;
}

int merge(const Options& options, std::ostream& out) {
  std::vector<Store> parts;
  for (const std::string& folder : options.parts) parts.emplace_back(folder);
  const Plan plan = parts.front().plan();
  const std::string study = parts.front().manifest();
  for (std::size_t i = 1; i < parts.size(); ++i) {
    if (parts[i].manifest() != study || to_csv(parts[i].plan()) != to_csv(plan)) {
      throw UsageError("'" + options.parts[i] + "' and '" + options.parts.front() +
                       "' are parts of different studies (their study.json or plan.csv differ)");
    }
  }
  std::vector<Found> found;
  for (const Run& run : plan.runs) found.push_back(find_run(run, parts));
  const Store store(options.out);
  store.begin(study, plan, true);
  for (std::size_t i = 0; i < found.size(); ++i) store.keep(found[i].row, found[i].part->path(plan.runs[i]));
  store.finish(plan);
  tell(plan, store, out);
  out << plan.runs.size() << " runs: " << options.out << "/summary.json" << std::endl;
  return 0;
}

}  // namespace

int program(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& errors) {
  try {
    const Options options = parse_options(arguments);
    if (options.command == "help") {
      out << help();
      return 0;
    }
    return options.command == "merge" ? merge(options, out) : experiment(options, out, errors);
  } catch (const UsageError& e) {
    errors << "hidwa_study: " << e.what() << std::endl;
    return 2;
  } catch (const std::exception& e) {
    errors << "hidwa_study: " << e.what() << std::endl;
    return 1;
  }
}

}  // namespace study
}  // namespace hidwa_local_planner
