// SPDX-License-Identifier: BSD-3-Clause
// Where a test runs hidwa_study: a folder of its own, gone afterwards.
#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "study/program.hpp"
#include "study/table.hpp"

namespace hidwa_local_planner {
namespace study {

class StudyFolder : public ::testing::Test {
 protected:
  struct Ended {
    int code = -1;
    std::string out, errors;
  };

  void SetUp() override {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::temp_directory_path() /
              (std::string("hidwa_study_test_") + info->test_suite_name() + "_" + info->name());
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  std::string read(const std::string& name) const {
    std::ifstream file(folder_ / name, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
  }

  /// Words that begin with @ are in the test's folder; `more` are taken as they are.
  Ended run(const std::string& line, const std::vector<std::string>& more = {}) const {
    std::istringstream stream(line);
    std::vector<std::string> arguments;
    for (std::string word; stream >> word;) arguments.push_back(word[0] == '@' ? path(word.substr(1)) : word);
    arguments.insert(arguments.end(), more.begin(), more.end());
    std::ostringstream out, errors;
    Ended ended;
    ended.code = program(arguments, out, errors);
    ended.out = out.str();
    ended.errors = errors.str();
    return ended;
  }

  /// The lines of runs.csv, the one with the names first.
  std::vector<Row> lines_of(const std::string& out) const {
    std::istringstream lines(read(out + "/runs.csv"));
    std::vector<Row> all;
    for (std::string line; std::getline(lines, line);) {
      all.push_back(from_line(line));
      EXPECT_EQ(all.back().size(), all.front().size());
    }
    return all;
  }

  /// The cell in this column of each line, or of the line with this id.
  std::vector<std::string> column(const std::string& out, const std::string& name) const {
    const std::vector<Row> lines = lines_of(out);
    std::vector<std::string> cells;
    for (std::size_t k = 1; k < lines.size(); ++k) cells.push_back(cell(lines[k], name, lines[0]));
    return cells;
  }
  std::string at(const std::string& out, const std::string& id, const std::string& name) const {
    const std::vector<Row> lines = lines_of(out);
    for (const Row& line : lines) {
      if (line.front() == id) return cell(line, name, lines.front());
    }
    return "none";
  }

  /// A line that makes no sense ends with 2 and names what is wrong, or the remedy.
  void expect_refused(const std::string& line, const std::string& part,
                      const std::vector<std::string>& more = {}) const {
    const Ended ended = run(line, more);
    EXPECT_EQ(ended.code, 2) << line;
    EXPECT_NE(ended.errors.find(part), std::string::npos) << line << ": " << ended.errors;
  }

  /// The study that `line` makes in `out`, made in two parts as well and joined, is the same.
  void expect_sum_of_its_parts(const std::string& line, const std::string& out,
                               const std::vector<std::string>& more = {}) const {
    ASSERT_EQ(run(line + " --out @part1 --shard 1/2", more).code, 0);
    ASSERT_EQ(run(line + " --out @part2 --shard 2/2", more).code, 0);
    EXPECT_EQ(lines_of("part1").size() + lines_of("part2").size(), lines_of(out).size() + 1) << "each has a head";
    const Ended merged = run("merge --out @joined @part2 @part1");
    ASSERT_EQ(merged.code, 0) << merged.errors;
    expect_same(out, "joined");
  }

  /// Every file that holds no time of the computer's.
  void expect_same(const std::string& a, const std::string& b) const {
    for (const char* name : {"/runs.csv", "/summary.json", "/study.json", "/plan.csv"}) {
      EXPECT_FALSE(read(a + name).empty()) << name;
      EXPECT_EQ(read(a + name), read(b + name)) << name;
    }
    const std::vector<Row> lines = lines_of(a);
    ASSERT_FALSE(lines.empty());
    EXPECT_EQ(lines.front().front(), "id");
    for (std::size_t k = 1; k < lines.size(); ++k) {
      const std::string name = "/paths/" + lines[k].front() + ".csv";
      EXPECT_FALSE(read(a + name).empty()) << name;
      EXPECT_EQ(read(a + name), read(b + name)) << name;
    }
  }

  std::filesystem::path folder_;
};

}  // namespace study
}  // namespace hidwa_local_planner
