// SPDX-License-Identifier: BSD-3-Clause
// hidwa_ways: does autonomy find every way that is there? See docs/evidence/ways.md.
#include <cstdio>
#include <filesystem>
#include <stdexcept>

#include "ways/arguments.hpp"
#include "ways/campaign.hpp"
#include "ways/picture.hpp"
#include "ways/report.hpp"

namespace hidwa_ways {
namespace {

constexpr const char* kHelp =
    "A robot alone in tight places: does autonomy find the way where an exhaustive search finds one, and does it say "
    "so\n"
    "where there is none?\n"
    "  [--scenes N] [--first-seed N] [--kinds NAME[,NAME...]] [--barn FILE] [--map FILE.yaml]... [--jobs N] [--out "
    "DIR]\n"
    "                   5,000 scenes of all kinds, BARN worlds and gaps of maps among them; scenes.csv and table.txt "
    "go to DIR\n"
    "  --scene KIND --seed N [--trace FILE.csv] [--picture FILE.svg]\n"
    "                   one scene alone: what happened each cycle; map, plan, way found and way driven\n"
    "  --list           the kinds of scenes\n"
    "exit status: 0 every bar was reached; 1 not; 2 something did not run\n";

std::vector<Kind> available(const Arguments& arguments) {
  std::vector<Kind> kinds = drawn_kinds();
  for (const std::string& file : arguments.list("--barn")) kinds.push_back(barn_kind(file));
  for (const std::string& yaml : arguments.list("--map")) kinds.push_back(map_kind(yaml));
  return kinds;
}

const Kind& find(const std::vector<Kind>& kinds, const std::string& name) {
  for (const Kind& kind : kinds) {
    if (kind.name == name) return kind;
  }
  throw std::invalid_argument("no kind '" + name + "'; --list names them, --barn and --map add some");
}

int one_scene(const std::vector<Kind>& kinds, const Arguments& arguments) {
  const Kind& kind = find(kinds, arguments.text("--scene"));
  std::ofstream trace = arguments.trace();
  const Account account = run_scene(kind, arguments.seed("--seed"), trace.is_open() ? &trace : nullptr);
  std::printf("%s\n", in_words(account.result).c_str());
  if (arguments.has("--picture")) write_file(arguments.text("--picture"), picture(account));
  return account.result.good() ? 0 : 1;
}

int all_scenes(const std::vector<Kind>& kinds, const Arguments& arguments) {
  Extent extent;
  for (const std::string& name : arguments.list("--kinds")) extent.kinds.push_back(&find(kinds, name));
  if (extent.kinds.empty()) {
    for (const Kind& kind : kinds) extent.kinds.push_back(&kind);
  }
  const long scenes = arguments.whole("--scenes", 5000, 1), count = static_cast<long>(extent.kinds.size());
  extent.scenes = static_cast<int>((scenes + count - 1) / count);
  extent.first_seed = arguments.seed("--first-seed");
  extent.threads = static_cast<int>(arguments.whole("--jobs", 1, 1));
  int done = 0;
  const std::vector<Result> results = run(extent, [&done](const Result&) {
    if (++done % 100 == 0) std::fprintf(stderr, "%d scenes\n", done);
  });
  const std::vector<Summary> summaries = summaries_of(results);
  const std::string lines = failures(results);
  const std::string told =
      table(summaries) + (lines.empty() ? "" : "\nnot as asked; each alone: hidwa_ways and\n" + lines);
  std::printf("%s", told.c_str());
  if (arguments.has("--out")) {
    const std::string out = arguments.text("--out");
    std::filesystem::create_directories(out);
    write_file(out + "/scenes.csv", scenes_csv(results));
    write_file(out + "/table.txt", told);
  }
  return summaries.back().held() ? 0 : 1;
}

int main_with(const Arguments& arguments) {
  if (arguments.has("--help")) {
    std::printf("%s", kHelp);
    return 0;
  }
  const std::vector<Kind> kinds = available(arguments);
  if (arguments.has("--list")) {
    for (const Kind& kind : kinds) std::printf("%s\n", kind.name.c_str());
    return 0;
  }
  return arguments.has("--scene") ? one_scene(kinds, arguments) : all_scenes(kinds, arguments);
}

}  // namespace
}  // namespace hidwa_ways

int main(int count, char** words) {
  try {
    return hidwa_ways::main_with(
        {count,
         words,
         {"--scenes", "--first-seed", "--kinds", "--barn", "--map", "--jobs", "--out", "--scene", "--seed", "--trace",
          "--picture"},
         {"--list", "--help"},
         {{"--scene", "--seed"}, {"--seed", "--scene"}, {"--trace", "--scene"}, {"--picture", "--scene"}}});
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "hidwa_ways: %s\n%s", fault.what(), hidwa_ways::kHelp);
    return 2;
  }
}
