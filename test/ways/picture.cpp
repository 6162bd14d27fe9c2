// SPDX-License-Identifier: BSD-3-Clause
#include "ways/picture.hpp"

#include <cmath>
#include <sstream>

namespace hidwa_ways {
namespace {

constexpr double kScale = 100.0;   // pixels a metre
constexpr double kOutlines = 0.3;  // between two outlines, and as many rad [m]

class Drawing {
 public:
  explicit Drawing(const Account& account) : account_(account), part_(account.scene.local_map()) {
    const double margin = 0.5;
    part_ = {part_.x - margin, part_.y - margin, part_.side + 2.0 * margin};
  }

  std::string whole() {
    const double side = kScale * part_.side;
    out_ << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << side << "\" height=\"" << side + 24 << "\">\n"
         << "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
    cells();
    const Region map = account_.scene.local_map();
    out_ << "<rect x=\"" << px(map.x) << "\" y=\"" << py(map.y + map.side) << "\" width=\"" << kScale * map.side
         << "\" height=\"" << kScale * map.side << "\" fill=\"none\" stroke=\"#999\" stroke-dasharray=\"6 4\"/>\n";
    line(account_.scene.plan, "#2a9d3a");
    const std::vector<Pose2> found = account_.finding.way.poses(0.02, 0.05);
    if (account_.finding.answer == Class::sure) outlined(found, "#1f4e9c");
    outlined(account_.driven, "#d62728");
    outline(account_.scene.start, "#22303c", 2.0);
    out_ << "<text x=\"4\" y=\"" << side + 16 << "\" font-family=\"sans-serif\" font-size=\"12\">"
         << account_.result.repeat << ": plan green, way found blue, driven red</text>\n</svg>\n";
    return out_.str();
  }

 private:
  double px(double x) const { return kScale * (x - part_.x); }
  double py(double y) const { return kScale * (part_.y + part_.side - y); }

  // A row's lethal cells that touch are one rectangle.
  void cells() {
    const World& world = account_.scene.world;
    const int first = world.cell(part_.x), last = world.cell(part_.x + part_.side);
    for (int j = world.cell(part_.y); j <= world.cell(part_.y + part_.side); ++j) {
      for (int i = first, begin = first; i <= last + 1; ++i) {
        if (i <= last && world.lethal(i, j)) continue;
        if (i > begin) bar(begin, i, j);
        begin = i + 1;
      }
    }
  }

  void bar(int from, int to, int row) {
    const double cell = account_.scene.world.resolution();
    out_ << "<rect x=\"" << px(from * cell) << "\" y=\"" << py((row + 1) * cell) << "\" width=\""
         << kScale * (to - from) * cell << "\" height=\"" << kScale * cell << "\" fill=\"#22303c\"/>\n";
  }

  void line(const std::vector<Pose2>& poses, const char* colour) {
    out_ << "<polyline fill=\"none\" stroke=\"" << colour << "\" stroke-width=\"2\" points=\"";
    for (const Pose2& p : poses) out_ << px(p.x) << ',' << py(p.y) << ' ';
    out_ << "\"/>\n";
  }

  void outlined(const std::vector<Pose2>& poses, const char* colour) {
    line(poses, colour);
    const Pose2* last = nullptr;
    for (const Pose2& p : poses) {
      const bool far =
          last == nullptr || std::hypot(p.x - last->x, p.y - last->y) + std::abs(p.theta - last->theta) > kOutlines;
      if (!far && &p != &poses.back()) continue;
      outline(p, colour, 0.7);
      last = &p;
    }
  }

  void outline(const Pose2& pose, const char* colour, double width) {
    out_ << "<polygon fill=\"none\" stroke=\"" << colour << "\" stroke-width=\"" << width << "\" points=\"";
    const double c = std::cos(pose.theta), s = std::sin(pose.theta);
    for (const Spot& p : hidwa_attack::told_corners(account_.scene.body.shape))
      out_ << px(pose.x + c * p.x - s * p.y) << ',' << py(pose.y + s * p.x + c * p.y) << ' ';
    out_ << "\"/>\n<line stroke=\"" << colour << "\" x1=\"" << px(pose.x) << "\" y1=\"" << py(pose.y) << "\" x2=\""
         << px(pose.x + 0.15 * c) << "\" y2=\"" << py(pose.y + 0.15 * s) << "\"/>\n";
  }

  const Account& account_;
  Region part_;
  std::ostringstream out_;
};

}  // namespace

std::string picture(const Account& account) { return Drawing(account).whole(); }

}  // namespace hidwa_ways
