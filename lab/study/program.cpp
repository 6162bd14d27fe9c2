// SPDX-License-Identifier: BSD-3-Clause
#include "study/program.hpp"

#include <cstdint>
#include <exception>
#include <map>
#include <utility>

#include "core/util/words.hpp"
#include "execution.hpp"
#include "experiments.hpp"
#include "files.hpp"
#include "floor.hpp"
#include "study/error.hpp"
#include "study/options.hpp"
#include "study/scene.hpp"
#include "study/seed.hpp"

namespace hidwa_local_planner {
namespace study {
namespace {

std::string fingerprint_of(const sim::OccupancyMap& map) {
  std::string cells;
  for (const sim::Cell cell : map.cells) cells += static_cast<char>(cell);
  return format("%d x %d, %.4f m, %.4f %.4f, ", map.width, map.height, map.resolution, map.origin_x, map.origin_y) +
         fingerprint(cells);
}

nlohmann::json what_decides(const Options& o, const Scene& scene) {
  return {{"participants", o.participants},
          {"profile", o.profile},
          {"guard", o.guard == Guard::none ? "none" : "nearest"},
          {"map", fingerprint_of(*scene.ground->map())},
          {"regions", fingerprint_of_file(o.regions)},
          {"start", json_of(scene.start)},
          {"goal", json_of(scene.goal)}};
}

Parameters profile(const std::string& name) {
  Parameters parameters;
  assign_file(parameters, share_file("launch/params/telepresence_base.yaml"));
  if (name == "paper") assign_file(parameters, share_file("launch/params/paper.yaml"));
  return parameters;
}

Plan plan_of(const Options& options) {
  const bool pilot = options.command == "pilot";
  const std::vector<Setting> settings = pilot ? pilot_settings() : settings_of(options);
  if (settings.size() > 99999) throw UsageError("there are more than 99999 combinations: take fewer values");
  return make_plan(options.command, options.participants, options.conditions, settings, pilot);
}

/// What a participant is and what they drive, with everything set that the user set.
Subject subject_of(const Options& options, const Parameters& base, const Setting& setting, const std::string& condition,
                   int participant) {
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
    check(setting, subject.parameters);
  }
}

// With simulated people: run, pilot and sweep.
int people(const Options& asked, std::ostream& out, std::ostream& errors) {
  const Options options = with_floor(asked);
  const Plan plan = plan_of(options);
  const Parameters base = profile(options.profile);
  check_settings(options, base, plan);
  const Scene scene = scene_of(options);
  const auto make = [&](const Run& run) {
    const Seeds seeds = seeds_of(options.seed, run);
    const Subject subject = subject_of(options, base, plan.settings[run.setting], run.condition, run.participant);
    Driven driven = drive_once(scene, subject, seeds.world, seeds.person);
    Row row = row_of(plan, run, seeds.world, driven);
    return Made{std::move(row), std::move(driven.result)};
  };
  return execute(options, plan, what_decides(options, scene), make, out, errors);
}

int tell_help(const Options&, std::ostream& out, std::ostream&) {
  out << help();
  return 0;
}

using Command = int (*)(const Options& options, std::ostream& out, std::ostream& errors);

Command command_of(const std::string& name) {
  static const std::map<std::string, Command> commands{{"run", people},  {"pilot", people},      {"sweep", people},
                                                       {"barn", barn},   {"dynabarn", dynabarn}, {"crowd", crowd},
                                                       {"gap", gap},     {"passage", passage},   {"attack", attack},
                                                       {"merge", merge}, {"help", tell_help}};
  return commands.at(name);
}

}  // namespace

int program(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& errors) {
  try {
    const Options options = parse_options(arguments);
    return command_of(options.command)(options, out, errors);
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
