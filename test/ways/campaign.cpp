// SPDX-License-Identifier: BSD-3-Clause
#include "ways/campaign.hpp"

#include <atomic>
#include <mutex>
#include <thread>
#include <utility>

#include "ways/drive.hpp"

namespace hidwa_ways {
namespace {

Result begin_result(const Scene& scene, const Finding& finding) {
  Result result;
  result.kind = scene.kind->name;
  result.body = scene.body.name;
  result.repeat = "--scene " + scene.kind->name + " --seed " + std::to_string(scene.seed);
  if (!scene.kind->source.empty()) result.repeat += " " + scene.kind->source;
  result.seed = scene.seed;
  result.reverse = scene.reverse;
  result.resolution = scene.world.resolution();
  result.answer = finding.answer;
  if (finding.answer == Class::sure)
    result.verified =
        deepest_along(finding.way, scene.world, hidwa_attack::padded(scene.body.shape, scene.margin())) <= 0.0;
  return result;
}

}  // namespace

Account run_scene(const Kind& kind, std::uint64_t seed, std::ostream* trace) {
  Scene scene = scene_of(kind, seed);
  Finding finding = examine(scene);
  Result result = begin_result(scene, finding);
  std::vector<Pose2> driven;
  drive(scene, finding, result, trace, &driven);
  return {std::move(result), std::move(scene), std::move(finding), std::move(driven)};
}

std::vector<Result> run(const Extent& extent, const std::function<void(const Result&)>& seen) {
  const auto each = static_cast<std::size_t>(extent.scenes);
  std::vector<Result> results(extent.kinds.size() * each);
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  const auto work = [&] {
    for (std::size_t k = next++; k < results.size(); k = next++) {
      results[k] = run_scene(*extent.kinds[k / each], extent.first_seed + k % each).result;
      const std::lock_guard<std::mutex> lock(mutex);
      if (seen) seen(results[k]);
    }
  };
  std::vector<std::thread> others;
  for (int k = 1; k < extent.threads; ++k) others.emplace_back(work);
  work();
  for (std::thread& other : others) other.join();
  return results;
}

}  // namespace hidwa_ways
