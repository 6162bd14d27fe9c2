// SPDX-License-Identifier: BSD-3-Clause
#include "study/tables.hpp"

#include <gtest/gtest.h>

namespace hidwa_local_planner {
namespace study {
namespace {

Row row(const Plan& plan, std::size_t run, double duration, int crossed, int contacts) {
  Driven driven;
  driven.result.arrived = true;
  driven.result.ending = drive::Ending::arrived;
  driven.result.duration = duration;
  driven.result.regions_crossed = crossed;
  driven.result.contacts = contacts;
  return row_of(plan, plan.runs[run], 5, driven);
}

TEST(Summary, StatisticsOfAFewNumbers) {
  const Statistics s = statistics({4.0, 1.0, 2.0, 3.0});
  EXPECT_EQ(s.mean, 2.5);
  EXPECT_EQ(s.median, 2.5);
  EXPECT_NEAR(s.sd, 1.2909944487, 1e-9);
  EXPECT_EQ(s.min, 1.0);
  EXPECT_EQ(s.max, 4.0);
  EXPECT_EQ(statistics({3.0, 9.0, 1.0}).median, 3.0);
  EXPECT_EQ(statistics({3.0}).sd, 0.0);
}

TEST(Summary, NumbersAreWrittenInOneWay) {
  EXPECT_EQ(number(1.0 / 3.0), "0.333333");
  EXPECT_EQ(number(-0.0), "0.000000");
  EXPECT_EQ(number(-1e-9), "0.000000");
  EXPECT_EQ(number(-2.0), "-2.000000");
}

TEST(Summary, ALineIsReadAsItWasWritten) {
  const Plan plan = make_plan("run", 1, {"SJ"}, {{}}, false);
  const Row written = row(plan, 0, 12.5, 1, 0);
  ASSERT_EQ(written.size(), columns().size());
  EXPECT_EQ(from_line(to_line(written) + "\n"), written);
  EXPECT_EQ(value(written, "duration"), 12.5);
  EXPECT_EQ(cell(written, "condition"), "SJ");
  EXPECT_EQ(measures().front(), "duration");
}

TEST(Summary, TheBestSettingIsRankedFirst) {
  const Plan plan = make_plan("sweep", 1, {"SJ"}, combinations({"s_v=1,2,3"}), false);
  const std::string csv =
      ranking_csv(people_tables(), plan, {row(plan, 0, 10.0, 1, 0), row(plan, 1, 12.0, 0, 0), row(plan, 2, 5.0, 0, 1)});
  const std::size_t first = csv.find("1,SJ,s_v=2"), second = csv.find("2,SJ,s_v=1"), third = csv.find("3,SJ,s_v=3");
  ASSERT_NE(third, std::string::npos) << csv;
  EXPECT_LT(first, second);
  EXPECT_LT(second, third);
}

TEST(Summary, GroupsAreConditionsAndSettings) {
  const Plan plan = make_plan("run", 2, {"SJ", "SW"}, {{}}, false);
  std::vector<Row> rows;
  for (std::size_t i = 0; i < 4; ++i) rows.push_back(row(plan, i, 10.0 + static_cast<double>(i), 0, 0));
  const Tables tables = people_tables();
  const std::vector<Group> all = groups(tables, plan, rows);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].names.front(), "SJ");
  EXPECT_EQ(all[1].rows.size(), 2u);
  EXPECT_NE(summary_json(tables, plan, rows).find("\"n\": 2"), std::string::npos);
}

}  // namespace
}  // namespace study
}  // namespace hidwa_local_planner
