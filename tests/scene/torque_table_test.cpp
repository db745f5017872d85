// SPDX-License-Identifier: Apache-2.0
#include "scene/assembly/torque_table.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace poinsot::scene {
namespace {

std::string problemOf(const std::string& csv) {
  try {
    parseTorqueTable(csv, true);
    return "";
  } catch (const core::Error& error) {
    EXPECT_EQ(error.kind(), core::ErrorKind::kScene);
    return error.message();
  }
}

TEST(TorqueTable, ReadsATimeAndATorqueFromEachLine) {
  for (const char* csv : {"t,Nx,Ny,Nz\n-1,2,3,4\n0.5,-1e-3,0,+7\n", "-1, 2, 3, 4\r\n0.5,-0.001,0,7",
                          "\xef\xbb\xbft,Nx,Ny,Nz\n-1,2,3,4\n\t.5,-1e-3,0,7 \n"}) {
    const physics::TorqueHistory history = parseTorqueTable(csv, false);
    EXPECT_EQ(history.t_s, (std::vector<double>{-1, 0.5})) << csv;
    EXPECT_EQ(history.torque, (std::vector<Eigen::Vector3d>{{2, 3, 4}, {-1e-3, 0, 7}})) << csv;
    EXPECT_FALSE(history.linear);
  }
}

TEST(TorqueTable, ErrorsNameTheFaultyLine) {
  const std::string good = "t,Nx,Ny,Nz\n0,1,2,3\n";
  const auto got = [](const std::string& line) {
    return "line 3: expected four numbers t,Nx,Ny,Nz, got \"" + line + "\"";
  };
  for (const char* line : {"1,2,3", "1,2,3,4,5", "1,2,3,4,", "1,2,x,4", "1;2;3;4", "1,2,,4", "1,2,3,4 # end",
                           "nan,1,2,3", "1,inf,2,3", "1,1e999,2,3", "1,0x10,2,3", "t,Nx,Ny,Nz", "+-1,2,3,4"})
    EXPECT_EQ(problemOf(good + line + "\n"), got(line));
  EXPECT_EQ(problemOf(good + "\n1,2,3,4\n"), got(""));
  EXPECT_EQ(problemOf(good + "0,2,3,4\n"), "line 3: times must ascend, got 0 after 0");
  EXPECT_EQ(problemOf("time,x,y,z\n"), "line 1: expected four numbers t,Nx,Ny,Nz, got \"time,x,y,z\"");
  EXPECT_EQ(problemOf(good + "1e21,0,0,0\n"), "line 3: absolute values must be at most 1e+20, got 1e+21");
  EXPECT_EQ(problemOf(good + "1,0,-1e141,0\n"), "line 3: absolute values must be at most 1e+140, got -1e+141");
  EXPECT_EQ(problemOf(good + "\x1b[31m\n"), got("\\x1b[31m"));
}

TEST(TorqueTable, RejectsEmptyAndTooLongTables) {
  EXPECT_EQ(problemOf(""), "the table has no rows of numbers t,Nx,Ny,Nz");
  EXPECT_EQ(problemOf("t,Nx,Ny,Nz\n"), "the table has no rows of numbers t,Nx,Ny,Nz");
  std::string csv;
  for (int i = 0; i < 100'000; ++i) csv += std::to_string(i) + ",0,0,1\n";
  EXPECT_EQ(problemOf(csv), "");
  EXPECT_EQ(problemOf(csv + "100000,0,0,1\n"), "line 100001: a table may have at most 100000 lines");
}

}  // namespace
}  // namespace poinsot::scene
