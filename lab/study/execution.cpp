// SPDX-License-Identifier: BSD-3-Clause
#include "execution.hpp"

#include <cstddef>
#include <mutex>
#include <optional>
#include <vector>

#include "progress.hpp"
#include "study/error.hpp"
#include "study/runner.hpp"

namespace hidwa_local_planner {
namespace study {
namespace {

struct Timing {
  double simulated = 0.0;  // [s]
  double planning = 0.0;   // [s]
  std::size_t cycles = 0;
};

nlohmann::json json_of(const std::vector<Assignment>& sets) {
  nlohmann::json list = nlohmann::json::array();
  for (const Assignment& set : sets) list.push_back(set.name + "=" + set.value);
  return list;
}

std::string manifest(const Options& options, const Plan& plan, nlohmann::json all) {
  all["version"] = HIDWA_VERSION;
  all["experiment"] = plan.experiment;
  all["seed"] = options.seed;
  all["set"] = json_of(options.sets);
  all["paths"] = options.paths;
  return all.dump(2) + '\n';
}

std::string timing_json(std::size_t threads, std::size_t made, std::size_t kept, double wall, const Timing& timing) {
  nlohmann::json json = {{"runs_made", made},
                         {"runs_kept", kept},
                         {"threads", threads},
                         {"wall_time", wall},
                         {"simulated_time", timing.simulated}};
  if (timing.cycles > 0) json["mean_planning_time"] = timing.planning / static_cast<double>(timing.cycles);
  return json.dump(2) + '\n';
}

// Makes the tables of all runs that are finished, and tells of them. Returns the program's exit code.
int conclude(const Options& options, const Plan& plan, const Tables& tables, const Store& store, std::ostream& out) {
  const std::vector<Row> rows = store.finish(plan);
  const Verdict verdict = tables.verdict(plan, rows);
  out << digest(tables, plan, rows) << verdict.told << rows.size() << " of " << plan.runs.size()
      << " runs: " << options.out << "/summary.json" << std::endl;
  return verdict.held ? 0 : 1;
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

}  // namespace

int execute(const Options& options, const Plan& plan, const nlohmann::json& deciding,
            const std::function<Made(const Run&)>& make, std::ostream& out, std::ostream& errors) {
  const Tables tables = tables_of(plan.experiment);
  const Store store(options.out, tables);
  store.begin(manifest(options, plan, deciding), plan, options.resume);
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

  const std::size_t threads = threads_for(options.threads);
  Timing timing;
  std::mutex mutex;
  Progress progress(errors, wanted.size());
  const auto make_and_keep = [&](std::size_t number) {
    const Made made = make(wanted[number]);
    store.keep(made.row, options.paths ? path_csv(made.result) : "");
    const std::lock_guard<std::mutex> lock(mutex);
    timing.simulated += made.result.duration;
    timing.planning += made.result.planning_time;
    timing.cycles += made.result.cycles;
  };
  make_runs(wanted.size(), threads, make_and_keep, [&progress] { progress.step(); });
  store.write("timing.json", timing_json(threads, wanted.size(), kept, progress.elapsed(), timing));
  return conclude(options, plan, tables, store, out);
}

int merge(const Options& options, std::ostream& out, std::ostream&) {
  const Plan plan = Store(options.parts.front()).plan();
  const Tables tables = tables_of(plan.experiment);
  std::vector<Store> parts;
  for (const std::string& folder : options.parts) parts.emplace_back(folder, tables);
  const std::string study = parts.front().manifest();
  for (std::size_t i = 1; i < parts.size(); ++i) {
    if (parts[i].manifest() != study || to_csv(parts[i].plan()) != to_csv(plan)) {
      throw UsageError("'" + options.parts[i] + "' and '" + options.parts.front() +
                       "' are parts of different studies (their study.json or plan.csv differ)");
    }
  }
  std::vector<Found> found;
  for (const Run& run : plan.runs) found.push_back(find_run(run, parts));
  const Store store(options.out, tables);
  store.begin(study, plan, true);
  for (std::size_t i = 0; i < found.size(); ++i) store.keep(found[i].row, found[i].part->path(plan.runs[i]));
  return conclude(options, plan, tables, store, out);
}

}  // namespace study
}  // namespace hidwa_local_planner
