// SPDX-License-Identifier: BSD-3-Clause
#include "explanation.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include <nlohmann/json.hpp>

#include "words.hpp"

namespace hidwa_local_planner {
namespace replay {
namespace {

std::string rejections_in_words(const CandidateReport& candidate) {
  std::string text;
  for (const Rejection& rejection : candidate.rejections) {
    text += (text.empty() ? "" : "; ") + std::string(rejection.name) + ": " + rejection.reason;
  }
  return text;
}

std::string table(const std::vector<CandidateReport>& candidates, int best) {
  if (candidates.empty()) return "";
  std::string text = format("%6s %8s %8s", "#", "v", "omega");
  for (const CriticTerm& critic : candidates.front().terms) {
    text += format(" %*s", std::max(10, static_cast<int>(critic.name.size())), std::string(critic.name).c_str());
  }
  text += format(" %10s  rejected by\n", "J");
  for (std::size_t c = 0; c < candidates.size(); ++c) {
    const CandidateReport& candidate = candidates[c];
    text += format("%6zu %8.4f %8.4f", c, candidate.sample.v, candidate.sample.omega);
    for (const CriticTerm& critic : candidate.terms) {
      text += format(" %*.4f", std::max(10, static_cast<int>(critic.name.size())), critic.raw * critic.weight);
    }
    text += format(" %10.4f  %s%s%s\n", candidate.sum(), rejections_in_words(candidate).c_str(),
                   static_cast<int>(c) == best ? "<== chosen" : "", candidate.operator_command ? "  (u_h)" : "");
  }
  return text;
}

// How many each one rejects, whoever else does, and how many only that one does.
std::string count_rejections(const std::vector<CandidateReport>& candidates) {
  std::map<std::string, std::pair<int, int>> counts;
  int legal = 0;
  for (const CandidateReport& candidate : candidates) {
    legal += candidate.legal() ? 1 : 0;
    for (const Rejection& rejection : candidate.rejections) {
      auto& [all, alone] = counts[std::string(rejection.name)];
      ++all;
      alone += candidate.rejections.size() == 1 ? 1 : 0;
    }
  }
  std::string text = format("%zu candidates, %d legal", candidates.size(), legal);
  for (const auto& [name, count] : counts) {
    text += format("; %s rejects %d (%d of them alone)", name.c_str(), count.first, count.second);
  }
  return text + "\n";
}

// The cheapest legal candidate but one.
int runner_up(const std::vector<CandidateReport>& candidates, int best) {
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
std::string compare(const CandidateReport& a, const CandidateReport& b) {
  std::string text;
  for (std::size_t i = 0; i < a.terms.size(); ++i) {
    const double gain = b.terms[i].raw * b.terms[i].weight - a.terms[i].raw * a.terms[i].weight;
    if (std::abs(gain) < 5e-5) continue;
    text += format("%s%s %+.4f", text.empty() ? "" : ", ", std::string(a.terms[i].name).c_str(), gain);
  }
  return text.empty() ? "all critics score them alike" : text;
}

const char* reason_besides_total(ChoiceReport::Rule rule) {
  switch (rule) {
    case ChoiceReport::Rule::escape:
      return "it leads out of the collision that the robot stands in";
    case ChoiceReport::Rule::way:
      return "it gets farthest along the way that a search has found, or nearly as far and is the cheapest "
             "(method: hidwa)";
    case ChoiceReport::Rule::rest:
      return "the robot rests while a way is searched (method: hidwa)";
    case ChoiceReport::Rule::evasion:
      return "it gets out of the way of what moves (evasion_time)";
    case ChoiceReport::Rule::none:
    case ChoiceReport::Rule::cheapest:
      break;
  }
  return "";
}

std::string why_chosen(record::CycleReplay& replay) {
  const std::vector<CandidateReport> all = replay.planner().candidates();
  const int best = replay.planner().marked().best;
  if (best < 0 || all.empty()) return "";
  const CandidateReport& chosen = all[static_cast<std::size_t>(best)];
  std::string text = format("chosen: #%d %s, J = %.4f", best, in_words(chosen.sample).c_str(), chosen.total);
  const char* rule = reason_besides_total(replay.planner().choice().rule);
  if (*rule != '\0') return text + ": J did not decide alone; " + rule + "\n";
  const int second = runner_up(all, best);
  if (second < 0) return text + ": the only legal one\n";
  const CandidateReport& next = all[static_cast<std::size_t>(second)];
  text += next.total - chosen.total > 1e-9 ? ": the smallest J of all legal ones\n"
                                           : ": of those with the smallest J the one that the rule for ties prefers\n";
  return text + format("next best: #%d %s, J = %.4f; the chosen one gains: %s\n", second, in_words(next.sample).c_str(),
                       next.total, compare(chosen, next).c_str());
}

std::string about_operator(record::CycleReplay& replay, const record::ReplayedCycle& cycle) {
  if (cycle.intent.influence == Influence::none) return "nobody steers\n";
  std::string text = "operator command u_h = " + in_words(cycle.intent.u_h);
  const Decision* decision = replay.decision();
  if (decision == nullptr) return text + "\n";
  text += format(", agreement %.3f", decision->agreement);
  const std::vector<CandidateReport> all = replay.planner().candidates();
  const int own = replay.planner().marked().operator_command;
  if (own < 0 || all.empty()) return text + "\n";
  const CandidateReport& candidate = all[static_cast<std::size_t>(own)];
  text += format("; its candidate #%d %s is ", own, in_words(candidate.sample).c_str());
  if (!candidate.legal()) return text + "rejected by " + rejections_in_words(candidate) + "\n";
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

std::string about_sector(const SensorSector& sector) {
  constexpr double kDegree = M_PI / 180.0;
  return format("a sensor at (%.2f m, %.2f m) looks %.0f degrees wide and %.1f m far around %.0f degrees\n",
                sector.pose.x, sector.pose.y, sector.width / kDegree, sector.range, sector.pose.theta / kDegree);
}

std::string about_mover(const MovingObstacleEstimate& mover) {
  return format(
      "moving obstacle %u at (%.2f m, %.2f m) with (%.2f, %.2f) m/s, radius %.2f m, known within %.2f m and "
      "%.2f m/s, %.2f s old\n",
      mover.id, mover.position.x(), mover.position.y(), mover.velocity.x(), mover.velocity.y(), mover.radius,
      mover.position_deviation, mover.velocity_deviation, mover.age);
}

}  // namespace

std::string explain(double time, record::CycleReplay& replay, const record::ReplayedCycle& cycle) {
  const record::CycleRecord& record = replay.record();
  std::string text;
  if (replay.situation() != nullptr) {
    const Situation& s = *replay.situation();
    text += table(replay.planner().candidates(), replay.planner().marked().best) + "\n";
    text += format("cycle at %.3f s (ROS time %.3f): %s, influence %s\n", time, record.time(),
                   to_string(cycle.intent.state), name_of(cycle.intent.influence));
    text += format("robot at (%.3f m, %.3f m, %.3f rad), measured %s, last command %s\n", s.pose.x, s.pose.y,
                   s.pose.theta, in_words(s.velocity).c_str(), in_words(s.last_command).c_str());
    for (const MovingObstacleEstimate& mover : s.moving_obstacles) text += about_mover(mover);
    for (const SensorSector& sector : s.sensor_sectors) text += about_sector(sector);
    text += count_rejections(replay.planner().candidates());
  } else {
    text += format("cycle at %.3f s (ROS time %.3f): no plan was made: %s\n", time, record.time(),
                   record.observation.fault.c_str());
  }
  if (record.observation.host_stops) text += "the host stops the robot\n";
  text += about_operator(replay, cycle);
  text += why_chosen(replay);
  if (replay.decision() != nullptr && !replay.decision()->problem.empty()) {
    text += "problem: " + replay.decision()->problem + "\n";
  }
  text += "sent: " + in_words(cycle.decision) + "\n";
  if (!cycle.identical) text += "recorded: " + in_words(record.decision) + "\n";
  return text;
}

namespace {

using Json = nlohmann::json;

Json json_of(const Twist2& u) { return {u.v, u.omega}; }
Json json_of(const Pose2& q) { return {q.x, q.y, q.theta}; }
Json json_of(const Point& p) { return {p.x(), p.y()}; }

// What is not finite becomes null.
Json json_of(const CandidateReport& candidate) {
  Json terms = Json::array();
  for (const CriticTerm& critic : candidate.terms) terms.push_back(critic.raw * critic.weight);
  return {{"u", json_of(candidate.sample)}, {"end", json_of(candidate.poses.back())},     {"sum", candidate.sum()},
          {"total", candidate.total},       {"rejected", rejections_in_words(candidate)}, {"terms", terms}};
}

// Where it is in this cycle.
Json json_of(const MovingObstacleEstimate& mover) {
  return {{"id", mover.id},
          {"position", json_of(mover.position_now())},
          {"velocity", json_of(mover.velocity)},
          {"radius", mover.radius}};
}

Json json_of(const record::StoredGrid& grid) {
  return {{"width", grid.size_x},
          {"height", grid.size_y},
          {"resolution", grid.resolution},
          {"origin", {grid.origin_x, grid.origin_y}},
          {"costs", grid.costs}};
}

template <typename Items>
Json list_of(const Items& items) {
  Json list = Json::array();
  for (const auto& item : items) list.push_back(json_of(item));
  return list;
}

Json names_of(const std::vector<CriticTerm>& critics) {
  Json names = Json::array();
  for (const CriticTerm& critic : critics) names.push_back(std::string(critic.name));
  return names;
}

}  // namespace

std::string explain_as_json(double time, record::CycleReplay& replay, const record::ReplayedCycle& cycle) {
  const Decision* decision = replay.decision();
  const std::vector<CandidateReport> all = replay.planner().candidates();
  const bool steered = cycle.intent.influence != Influence::none;
  Json json = {{"time", time},
               {"state", to_string(cycle.intent.state)},
               {"outcome", to_string(cycle.decision.outcome)},
               {"command", json_of(cycle.decision.command)},
               {"u_h", steered ? json_of(cycle.intent.u_h) : Json()},
               {"reference", json_of(cycle.decision.reference)},
               {"outline", list_of(replay.setup().outline)},
               {"trajectory", decision != nullptr ? list_of(decision->trajectory) : Json::array()},
               {"best", replay.planner().marked().best},
               {"operator_own", replay.planner().marked().operator_command},
               {"critics", all.empty() ? Json::array() : names_of(all.front().terms)},
               {"candidates", list_of(all)},
               {"grid", json_of(replay.grid())}};
  if (const Situation* s = replay.situation()) {
    json["pose"] = json_of(s->pose);
    json["goal"] = json_of(s->goal);
    json["plan"] = list_of(s->plan);
    json["moving_obstacles"] = list_of(s->moving_obstacles);
  }
  return json.dump() + '\n';
}

}  // namespace replay
}  // namespace hidwa_local_planner
