// SPDX-License-Identifier: BSD-3-Clause
// hidwa_ways: does autonomy find every way that is there? See docs/evidence/ways.md.
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <stdexcept>
#include <utility>

#include "ways/campaign.hpp"
#include "ways/picture.hpp"
#include "ways/report.hpp"

namespace hidwa_ways {
namespace {

constexpr const char* kHelp =
    "hidwa_ways [--scenes N] [--first-seed N] [--kinds NAME[,NAME...]] [--barn FILE] [--map FILE.yaml[,FILE.yaml...]]\n"
    "           [--jobs N] [--out DIR]\n"
    "hidwa_ways --scene KIND --seed N [--trace FILE.csv] [--picture FILE.svg]   one scene alone\n"
    "hidwa_ways --list                                                          the kinds\n"
    "exit status: 0 every bar was reached; 1 not; 2 wrong arguments\n";

using Options = std::map<std::string, std::string>;

Options read(int count, char** words) {
  Options options;
  for (int k = 1; k < count; ++k) {
    const std::string word = words[k];
    const bool alone = word == "--list" || word == "--help";
    const char* known[] = {"--scenes", "--first-seed", "--kinds", "--barn",  "--map",    "--jobs",
                           "--out",    "--scene",      "--seed",  "--trace", "--picture"};
    bool takes = false;
    for (const char* name : known) takes = takes || word == name;
    if (!alone && !takes) throw std::invalid_argument("unknown option " + word);
    if (takes && k + 1 >= count) throw std::invalid_argument(word + " needs a value");
    options[word] = alone ? "" : words[++k];
  }
  return options;
}

long whole(const Options& options, const char* name, long fallback, long least) {
  const auto found = options.find(name);
  if (found == options.end()) return fallback;
  char* end = nullptr;
  const long value = std::strtol(found->second.c_str(), &end, 10);
  if (*end != '\0' || end == found->second.c_str() || value < least)
    throw std::invalid_argument(std::string(name) + ": '" + found->second + "' is no whole number of at least " +
                                std::to_string(least));
  return value;
}

// The parts of "a,b".
std::vector<std::string> parts(const Options& options, const char* name) {
  std::vector<std::string> all;
  const auto found = options.find(name);
  if (found == options.end()) return all;
  std::string words = found->second + ",";
  for (std::size_t comma = words.find(','); comma != std::string::npos; comma = words.find(',')) {
    if (comma > 0) all.push_back(words.substr(0, comma));
    words.erase(0, comma + 1);
  }
  return all;
}

std::vector<Kind> available(const Options& options) {
  std::vector<Kind> kinds = drawn_kinds();
  for (const std::string& file : parts(options, "--barn")) kinds.push_back(barn_kind(file));
  for (const std::string& yaml : parts(options, "--map")) kinds.push_back(map_kind(yaml));
  return kinds;
}

const Kind& find(const std::vector<Kind>& kinds, const std::string& name) {
  for (const Kind& kind : kinds) {
    if (kind.name == name) return kind;
  }
  throw std::invalid_argument("no kind '" + name + "'; --list names them, --barn and --map add some");
}

void write(const std::string& path, const std::string& content) {
  std::ofstream out(path);
  out << content;
  if (!out.flush()) throw std::invalid_argument("cannot write " + path);
}

int one_scene(const std::vector<Kind>& kinds, const Options& options) {
  const Kind& kind = find(kinds, options.at("--scene"));
  std::ofstream trace;
  const auto file = options.find("--trace");
  if (file != options.end()) trace.open(file->second);
  if (file != options.end() && !trace) throw std::invalid_argument("cannot write " + file->second);
  trace.precision(9);
  const auto seed = static_cast<std::uint64_t>(whole(options, "--seed", 1, 0));
  const Account account = run_scene(kind, seed, trace.is_open() ? &trace : nullptr);
  std::printf("%s\n", in_words(account.result).c_str());
  if (options.count("--picture") != 0) write(options.at("--picture"), picture(account));
  return account.result.good() ? 0 : 1;
}

int all_scenes(const std::vector<Kind>& kinds, const Options& options) {
  Extent extent;
  for (const std::string& name : parts(options, "--kinds")) extent.kinds.push_back(&find(kinds, name));
  if (extent.kinds.empty()) {
    for (const Kind& kind : kinds) extent.kinds.push_back(&kind);
  }
  const long scenes = whole(options, "--scenes", 5000, 1), count = static_cast<long>(extent.kinds.size());
  extent.scenes = static_cast<int>((scenes + count - 1) / count);
  extent.first_seed = static_cast<std::uint64_t>(whole(options, "--first-seed", 1, 0));
  extent.threads = static_cast<int>(whole(options, "--jobs", 1, 1));
  int done = 0;
  const std::vector<Result> results = run(extent, [&done](const Result&) {
    if (++done % 100 == 0) std::fprintf(stderr, "%d scenes\n", done);
  });
  const std::vector<Summary> summaries = summaries_of(results);
  const std::string lines = failures(results);
  std::printf("%s", table(summaries).c_str());
  if (!lines.empty()) std::printf("\nnot as asked; each alone: hidwa_ways and\n%s", lines.c_str());
  const auto out = options.find("--out");
  if (out != options.end()) {
    std::filesystem::create_directories(out->second);
    write(out->second + "/summary.json", as_json(summaries, results));
    write(out->second + "/scenes.csv", scenes_csv(results));
    write(out->second + "/table.txt", table(summaries));
  }
  return summaries.back().held() ? 0 : 1;
}

int main_with(const Options& options) {
  if (options.count("--help") != 0) {
    std::printf("%s", kHelp);
    return 0;
  }
  const std::vector<Kind> kinds = available(options);
  if (options.count("--list") != 0) {
    for (const Kind& kind : kinds) std::printf("%s\n", kind.name.c_str());
    return 0;
  }
  return options.count("--scene") != 0 ? one_scene(kinds, options) : all_scenes(kinds, options);
}

}  // namespace
}  // namespace hidwa_ways

int main(int count, char** words) {
  try {
    return hidwa_ways::main_with(hidwa_ways::read(count, words));
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "hidwa_ways: %s\n%s", fault.what(), hidwa_ways::kHelp);
    return 2;
  }
}
