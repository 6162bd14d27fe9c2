// SPDX-License-Identifier: BSD-3-Clause
#include "explanation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

#include "words.hpp"

namespace hidwa_local_planner {
namespace replay {
namespace {

struct Refusal {
  std::string who;
  const char* why;
};

// Everybody who refuses a candidate.
std::vector<Refusal> refusals_of(const CandidateVerdict& candidate) {
  std::vector<Refusal> refusals;
  if (candidate.collision != nullptr) refusals.push_back({"Collision", candidate.collision});
  if (!candidate.can_brake) refusals.push_back({"Braking", "cannot stop in free space"});
  for (const CriticVerdict& critic : candidate.critics) {
    if (critic.reason != nullptr && critic.weight != 0.0) refusals.push_back({std::string(critic.name), critic.reason});
  }
  return refusals;
}

std::string refusals_in_words(const CandidateVerdict& candidate) {
  std::string text;
  for (const Refusal& refusal : refusals_of(candidate))
    text += (text.empty() ? "" : "; ") + refusal.who + ": " + refusal.why;
  return text;
}

std::string table(const std::vector<CandidateVerdict>& candidates, int best) {
  if (candidates.empty()) return "";
  std::string text = format("%6s %8s %8s", "#", "v", "omega");
  for (const CriticVerdict& critic : candidates.front().critics) {
    text += format(" %*s", std::max(10, static_cast<int>(critic.name.size())), std::string(critic.name).c_str());
  }
  text += format(" %10s  refused by\n", "J");
  for (std::size_t c = 0; c < candidates.size(); ++c) {
    const CandidateVerdict& candidate = candidates[c];
    text += format("%6zu %8.4f %8.4f", c, candidate.sample.v, candidate.sample.omega);
    for (const CriticVerdict& critic : candidate.critics) {
      text += format(" %*.4f", std::max(10, static_cast<int>(critic.name.size())), critic.raw * critic.weight);
    }
    text += format(" %10.4f  %s%s%s\n", candidate.sum, refusals_in_words(candidate).c_str(),
                   static_cast<int>(c) == best ? "<== chosen" : "", candidate.operator_own ? "  (u_h)" : "");
  }
  return text;
}

// How many each one refuses, whoever else does, and how many only that one does.
std::string count_refusals(const std::vector<CandidateVerdict>& candidates) {
  std::map<std::string, std::pair<int, int>> counts;
  int legal = 0;
  for (const CandidateVerdict& candidate : candidates) {
    const std::vector<Refusal> refusals = refusals_of(candidate);
    legal += refusals.empty() ? 1 : 0;
    for (const Refusal& refusal : refusals) {
      ++counts[refusal.who].first;
      counts[refusal.who].second += refusals.size() == 1 ? 1 : 0;
    }
  }
  std::string text = format("%zu candidates, %d legal", candidates.size(), legal);
  for (const auto& [name, count] : counts) {
    text += format("; %s refuses %d (%d of them alone)", name.c_str(), count.first, count.second);
  }
  return text + "\n";
}

// The cheapest legal candidate but one.
int runner_up(const std::vector<CandidateVerdict>& candidates, int best) {
  int second = -1;
  for (std::size_t c = 0; c < candidates.size(); ++c) {
    if (static_cast<int>(c) == best || !candidates[c].legal()) continue;
    if (second < 0 || candidates[c].total < candidates[static_cast<std::size_t>(second)].total) {
      second = static_cast<int>(c);
    }
  }
  return second;
}

// Where one candidate is cheaper than another, critic by critic.
std::string compare(const CandidateVerdict& a, const CandidateVerdict& b) {
  std::string text;
  for (std::size_t i = 0; i < a.critics.size(); ++i) {
    const double gain = b.critics[i].raw * b.critics[i].weight - a.critics[i].raw * a.critics[i].weight;
    if (std::abs(gain) < 5e-5) continue;
    text += format("%s%s %+.4f", text.empty() ? "" : ", ", std::string(a.critics[i].name).c_str(), gain);
  }
  return text.empty() ? "no critic tells them apart" : text;
}

std::string why_chosen(record::CycleReplay& replay) {
  const std::vector<CandidateVerdict>& all = replay.planner().verdicts();
  const int best = replay.planner().marked().best;
  if (best < 0 || all.empty()) return "";
  const CandidateVerdict& chosen = all[static_cast<std::size_t>(best)];
  std::string text = format("chosen: #%d %s, J = %.4f", best, in_words(chosen.sample).c_str(), chosen.total);
  if (replay.planner().choice().rule == ChoiceReport::Rule::way_out) {
    return text + ": not the cheapest, but the way out for a robot that stood still (turn_when_stuck)\n";
  }
  const int second = runner_up(all, best);
  if (second < 0) return text + ": the only legal one\n";
  const CandidateVerdict& next = all[static_cast<std::size_t>(second)];
  text += next.total - chosen.total > 1e-9 ? ": the smallest J of all legal ones\n"
                                           : ": of those with the smallest J the one that tie_break prefers\n";
  return text + format("next best: #%d %s, J = %.4f; the chosen one gains: %s\n", second, in_words(next.sample).c_str(),
                       next.total, compare(chosen, next).c_str());
}

std::string about_operator(record::CycleReplay& replay, const record::ReplayedCycle& cycle) {
  if (cycle.intent.influence == Influence::none) return "nobody steers\n";
  std::string text = "the person wants u_h = " + in_words(cycle.intent.u_h);
  const Decision* decision = replay.decision();
  if (decision == nullptr) return text + "\n";
  text += format(", agreement %.3f", decision->agreement);
  const std::vector<CandidateVerdict>& all = replay.planner().verdicts();
  const int own = replay.planner().marked().operator_own;
  if (own < 0 || all.empty()) return text + "\n";
  const CandidateVerdict& candidate = all[static_cast<std::size_t>(own)];
  text += format("; its candidate #%d %s is ", own, in_words(candidate.sample).c_str());
  if (!candidate.legal()) return text + "refused by " + refusals_in_words(candidate) + "\n";
  const int best = replay.planner().marked().best;
  if (best == own) return text + "the chosen one\n";
  if (best < 0) return text + "legal\n";
  return text + format("legal, J = %.4f; the chosen one gains: %s\n", candidate.total,
                       compare(all[static_cast<std::size_t>(best)], candidate).c_str());
}

const char* name_of(Influence influence) {
  switch (influence) {
    case Influence::none:
      return "none";
    case Influence::shared:
      return "shared";
    case Influence::direct:
      return "direct";
    case Influence::stop:
      return "stop";
  }
  return "?";
}

}  // namespace

std::string explain(double time, record::CycleReplay& replay, const record::ReplayedCycle& cycle) {
  const record::CycleRecord& record = replay.record();
  std::string text;
  if (replay.situation() != nullptr) {
    const Situation& s = *replay.situation();
    text += table(replay.planner().verdicts(), replay.planner().marked().best) + "\n";
    text += format("cycle at %.3f s (ROS time %.3f): %s, influence %s\n", time, record.time(),
                   to_string(cycle.intent.state), name_of(cycle.intent.influence));
    text += format("robot at (%.3f m, %.3f m, %.3f rad), measured %s, last command %s\n", s.pose.x, s.pose.y,
                   s.pose.theta, in_words(s.velocity).c_str(), in_words(s.last_command).c_str());
    text += count_refusals(replay.planner().verdicts());
  } else {
    text += format("cycle at %.3f s (ROS time %.3f): no plan was made: %s\n", time, record.time(),
                   record.observation.fault.c_str());
  }
  text += about_operator(replay, cycle);
  text += why_chosen(replay);
  if (replay.decision() != nullptr && !replay.decision()->problem.empty()) {
    text += "problem: " + replay.decision()->problem + "\n";
  }
  text += "sent: " + in_words(cycle.verdict) + "\n";
  if (!cycle.identical) text += "recorded: " + in_words(record.verdict) + "\n";
  return text;
}

namespace {

std::string json_of(const Twist2& u) { return "[" + json(u.v) + "," + json(u.omega) + "]"; }
std::string json_of(const Pose2& q) { return "[" + json(q.x) + "," + json(q.y) + "," + json(q.theta) + "]"; }

template <typename Items, typename Writer>
std::string json_list(const Items& items, const Writer& writer) {
  std::string text = "[";
  for (const auto& item : items) text += (text.size() > 1 ? "," : "") + writer(item);
  return text + "]";
}

std::string json_of(const CandidateVerdict& candidate) {
  return "{\"u\":" + json_of(candidate.sample) + ",\"end\":" + json_of(candidate.end) +
         ",\"sum\":" + json(candidate.sum) +
         ",\"total\":" + json(candidate.legal() ? candidate.total : std::numeric_limits<double>::infinity()) +
         ",\"refused\":" + json(refusals_in_words(candidate)) + ",\"terms\":" +
         json_list(candidate.critics, [](const CriticVerdict& critic) { return json(critic.raw * critic.weight); }) +
         "}";
}

}  // namespace

std::string explain_as_json(double time, record::CycleReplay& replay, const record::ReplayedCycle& cycle) {
  const record::StoredGrid& grid = replay.grid();
  const Decision* decision = replay.decision();
  const std::vector<CandidateVerdict>& all = replay.planner().verdicts();
  const bool steered = cycle.intent.influence != Influence::none;
  const auto point = [](const Point& p) { return "[" + json(p.x()) + "," + json(p.y()) + "]"; };
  const auto pose = [](const Pose2& q) { return json_of(q); };
  const auto whole = [](int number) { return std::to_string(number); };
  std::string text = "{\"time\":" + json(time) + ",\"state\":" + json(std::string(to_string(cycle.intent.state))) +
                     ",\"outcome\":" + json(std::string(to_string(cycle.verdict.outcome))) +
                     ",\"command\":" + json_of(cycle.verdict.command) +
                     ",\"u_h\":" + (steered ? json_of(cycle.intent.u_h) : "null") +
                     ",\"reference\":" + json_of(cycle.verdict.reference);
  if (const Situation* s = replay.situation()) {
    text += ",\"pose\":" + json_of(s->pose) + ",\"goal\":" + json_of(s->goal) + ",\"plan\":" + json_list(s->plan, pose);
  }
  text += ",\"outline\":" + json_list(replay.setup().outline, point) +
          ",\"trajectory\":" + (decision != nullptr ? json_list(decision->trajectory, pose) : "[]") +
          ",\"best\":" + whole(replay.planner().marked().best) +
          ",\"operator_own\":" + whole(replay.planner().marked().operator_own);
  text += ",\"critics\":" +
          (all.empty() ? std::string("[]") : json_list(all.front().critics, [](const CriticVerdict& critic) {
            return json(std::string(critic.name));
          }));
  text += ",\"candidates\":" + json_list(all, [](const CandidateVerdict& candidate) { return json_of(candidate); });
  text += ",\"grid\":{\"width\":" + whole(grid.size_x) + ",\"height\":" + whole(grid.size_y) +
          ",\"resolution\":" + json(grid.resolution) + ",\"origin\":[" + json(grid.origin_x) + "," +
          json(grid.origin_y) + "],\"costs\":" + json_list(grid.costs, whole) + "}}\n";
  return text;
}

}  // namespace replay
}  // namespace hidwa_local_planner
