// SPDX-License-Identifier: Apache-2.0
// CSV of other programs: variants that are accepted, and places that errors name. Columns were counted by hand.
#include "reference/grade_table.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>

#include "core/error.h"
#include "support/scratch_folder.h"

namespace poinsot::reference {
namespace {

TrajectoryTable table(const std::string& csv) { return parseTrajectoryTable(csv, "a.csv"); }

TEST(GradeTable, AcceptsAnyOrderAndIgnoresOtherColumns) {
  const auto t = table("note,omega_B_z,omega_B_x,t,omega_B_y\nfast,3,1,0.5,2\nslow,6,4,1.5,5\n");
  ASSERT_EQ(t.rows(), 2u);
  EXPECT_TRUE(t.has(kOmegaBAt));
  EXPECT_FALSE(t.has(kQAt));
  EXPECT_EQ(t.t_s(1), 1.5);
  EXPECT_EQ(t.at(0, kOmegaBAt), 1);
  EXPECT_EQ(t.at(0, kOmegaBAt + 1), 2);
  EXPECT_EQ(t.at(1, kOmegaBAt + 2), 6);
}

TEST(GradeTable, AcceptsByteOrderMarkQuotesAndComments) {
  const auto t = table(
      "\xef\xbb\xbf# made by an engine\r\n\"t\", omega_B_x ,omega_B_y,omega_B_z,\"a,b\"\r\n\r\n"
      " 1 ,+2,\"3\",nan,\"x, y\"\r\n# end\r\n");
  ASSERT_EQ(t.rows(), 1u);
  EXPECT_EQ(t.t_s(0), 1);
  EXPECT_EQ(t.at(0, kOmegaBAt), 2);
  EXPECT_EQ(t.at(0, kOmegaBAt + 1), 3);
  EXPECT_TRUE(std::isnan(t.at(0, kOmegaBAt + 2)));
}

/// Expects one row: t = 0.5, omega_B = (1, 2, 3).
void expectRow(const std::string& csv) {
  const auto t = table(csv);
  ASSERT_EQ(t.rows(), 1u) << csv;
  EXPECT_EQ(t.t_s(0), 0.5) << csv;
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(t.at(0, kOmegaBAt + i), static_cast<double>(i + 1)) << csv;
}

TEST(GradeTable, ReadsAHeaderInAComment) {
  // numpy.savetxt(file, rows, header=names) writes "# " before the names, e-notation and blanks as delimiters.
  expectRow("# t,omega_B_x,omega_B_y,omega_B_z\n5e-01,1e+00,2e+00,3e+00\n");
  expectRow("# t,omega_B_x,omega_B_y,omega_B_z\n5e-01 1e+00 2e+00 3e+00\n");
  expectRow("# my engine, 1.2\n#\n#t omega_B_x omega_B_y omega_B_z\n# s rad/s\n.5,1,2,3\n");
  // A header without # overrides one in a comment.
  expectRow("# t,q_w,q_x,q_y,q_z: also available\nt,omega_B_x,omega_B_y,omega_B_z\n.5,1,2,3\n");
}

TEST(GradeTable, ReadsColumnsSeparatedByBlanksAndTabs) {
  expectRow("t omega_B_x omega_B_y omega_B_z\n0.5 1 2 3\n");
  expectRow("  t   omega_B_x omega_B_y  omega_B_z  \r\n  0.5    1  2\t3 \r\n");
  expectRow("t\tomega_B_x\tomega_B_y\tomega_B_z\tnote\n0.5\t1\t2\t3\t\"two words\"\n");
}

TEST(GradeTable, NeedsNoNewlineAtTheEnd) { EXPECT_EQ(table("t,q_w,q_x,q_y,q_z\n0,1,0,0,0").rows(), 1u); }

std::string complaint(const std::string& csv) {
  try {
    table(csv);
  } catch (const core::Error& error) {
    EXPECT_EQ(error.kind(), core::ErrorKind::kIo);
    return error.what();
  }
  return "none";
}

TEST(GradeTable, ReportsLineAndColumnOfMistakes) {
  const std::string header = "t,omega_B_x,omega_B_y,omega_B_z\n";
  EXPECT_EQ(complaint(""), "a.csv: is empty; expected a first line with the names of the columns");
  EXPECT_EQ(complaint(header), "a.csv: has a header and no rows");
  EXPECT_EQ(complaint("x,y\n"),
            "a.csv:1: no column t; the first line must name the columns, separated by commas or blanks");
  EXPECT_EQ(complaint("0,1,2,3\n"),
            "a.csv:1: the first line holds numbers; expected the names of the columns: t,q_w,q_x,q_y,q_z,...");
  EXPECT_EQ(
      complaint("# my engine\n0,1,2,3\n"),
      "a.csv:2: no line names the columns: this line holds numbers, and no comment above it has known names; "
      "name them as in t,q_w,q_x,q_y,q_z,..., with or without a leading #");
  EXPECT_EQ(complaint("# time,q_w,q_x,q_y,q_z\n0,1,0,0,0\n"),
            "a.csv:1: no column t; if 'time' is the time, name it t");
  EXPECT_EQ(complaint("# t,t,q_w\n0,1,2\n"), "a.csv:1:5: column t occurs twice");
  EXPECT_EQ(complaint("# t,omega_B_x,omega_B_y,omega_B_z\n# none\n"), "a.csv: has a header and no rows");
  EXPECT_EQ(complaint("t omega_B_x omega_B_y omega_B_z\n0 1 2 x\n"), "a.csv:2:7: omega_B_z: 'x' is not a number");
  EXPECT_EQ(complaint("t omega_B_x omega_B_y omega_B_z\n0 1  2\n"),
            "a.csv:2: the row has 3 values, but the header has 4 columns");
  EXPECT_EQ(complaint("t; q_w; q_x\n"), complaint("t;q_w;q_x\n"));
  EXPECT_EQ(
      complaint("t;q_w;q_x\n"),
      "a.csv:1: columns are separated by semicolons; expected commas or blanks, and numbers with a decimal point");
  EXPECT_EQ(
      complaint("t,qx,qy,qz,qw\n"),
      "a.csv:1: no motion to grade: expected the columns q_w, q_x, q_y, q_z or omega_B_x, omega_B_y, omega_B_z, "
      "got qx, qy, qz, qw");
  for (const std::string time : {"time", "Time [s]", "t_s", "T (s)"})
    EXPECT_EQ(complaint("q_w," + time + "\n"), "a.csv:1: no column t; if '" + time + "' is the time, name it t");
  EXPECT_EQ(complaint("torque,title\n"),
            "a.csv:1: no column t; the first line must name the columns, separated by commas or blanks");
  EXPECT_EQ(complaint("t,q_w,q_x,q_z\n"), "a.csv:1: column q_y is missing; give all of q_w, q_x, q_y, q_z");
  EXPECT_EQ(complaint("t,t,q_w\n"), "a.csv:1:3: column t occurs twice");
  EXPECT_EQ(
      complaint("t,L_W_x,L_W_y,L_W_z\n0,1,2,3\n"),
      "a.csv:1: no motion to grade: expected the columns q_w, q_x, q_y, q_z or omega_B_x, omega_B_y, omega_B_z");
  EXPECT_EQ(complaint(header + "0,1,2,3\n1,1,x2,3\n"), "a.csv:3:5: omega_B_y: 'x2' is not a number");
  EXPECT_EQ(complaint(header + "0,1,2,\n"), "a.csv:2:7: omega_B_z: '' is not a number");
  EXPECT_EQ(complaint(header + "\n0,1,2\n"), "a.csv:3: the row has 3 values, but the header has 4 columns");
  EXPECT_EQ(complaint(header + " inf,1,2,3\n"), "a.csv:2:2: t: inf is not a finite number");
  EXPECT_EQ(complaint(header + "0,1,2,\x1b[2J\n"), "a.csv:2:7: omega_B_z: '\\x1b[2J' is not a number");
}

TEST(GradeTable, RejectsUnreadableFiles) {
  const ScratchFolder folder;
  const auto says = [&](const std::string& name) {
    try {
      readTrajectoryTable((folder / name).string());
    } catch (const core::Error& error) {
      EXPECT_EQ(error.kind(), core::ErrorKind::kIo);
      return error.message();
    }
    return std::string("nothing");
  };
  folder.put("empty.csv", "");
  std::filesystem::create_directory(folder / "folder");
  EXPECT_EQ(says("missing.csv"), "cannot be read: No such file or directory");
  EXPECT_EQ(says("folder"), "cannot be read: it is a directory");
  EXPECT_EQ(says("empty.csv"), "is empty; expected a first line with the names of the columns");
  ASSERT_EQ(::mkfifo((folder / "fifo").c_str(), 0600), 0);
  EXPECT_EQ(says("fifo"), "cannot be read: it is not a regular file");  // must not wait for a writer
  std::filesystem::create_symlink("/dev/zero", folder / "zero");
  EXPECT_EQ(says("zero"), "cannot be read: it is not a regular file");
}

std::string limitOn(const std::string& csv) {
  try {
    table(csv);
  } catch (const core::Error& error) {
    EXPECT_EQ(error.kind(), core::ErrorKind::kLimit);
    return error.what();
  }
  return "none";
}

TEST(GradeTable, LimitsLengthOfLinesAndNumberOfRows) {
  const std::string header = "t,omega_B_x,omega_B_y,omega_B_z,note\n";
  const std::string row = "0,1,2,3,";
  EXPECT_EQ(limitOn(header + row + std::string(kLongestTableLine - row.size(), 'x')), "none");
  EXPECT_EQ(limitOn(header + row + std::string(kLongestTableLine - row.size() + 1, 'x')),
            "a.csv:2: a line of more than 65536 bytes");
  std::string rows = "t,omega_B_x,omega_B_y,omega_B_z\n";
  for (std::size_t i = 0; i < kMostTableRows; ++i) rows += "0,1,2,3\n";
  EXPECT_EQ(limitOn(rows), "none");
  EXPECT_EQ(limitOn(rows + "0,1,2,3\n"), "a.csv:4000002: more than 4000000 rows");
}

/// Returns the error of trajectoryTableOf() for these columns; empty if it accepts them.
std::string refusal(const std::vector<NamedColumn>& columns) {
  try {
    trajectoryTableOf(columns);
  } catch (const core::Error& error) {
    EXPECT_EQ(error.kind(), core::ErrorKind::kUsage);
    return error.what();
  }
  return "";
}

TEST(GradeTable, AcceptsColumnsInMemory) {
  const std::vector<double> x{1, 4}, y{2, 5}, z{3, std::nan("")}, t_s{0.5, 1.5}, note{7};
  const auto t =
      trajectoryTableOf({{"note", note}, {"omega_B_z", z}, {"omega_B_x", x}, {"t", t_s}, {"omega_B_y", y}});
  ASSERT_EQ(t.rows(), 2u);
  EXPECT_EQ(t.t_s(1), 1.5);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(t.at(0, kOmegaBAt + i), static_cast<double>(i + 1));
  EXPECT_TRUE(std::isnan(t.at(1, kOmegaBAt + 2)));
  EXPECT_FALSE(t.has(kQAt));
}

TEST(GradeTable, ErrorsNameTheFaultyColumnInMemory) {
  const std::vector<double> two{1, 2}, three{1, 2, 3}, endless{0, INFINITY}, none;
  const auto with = [&](const std::vector<double>& t_s, const std::vector<double>& z) {
    return refusal({{"t", t_s}, {"omega_B_x", two}, {"omega_B_y", two}, {"omega_B_z", z}});
  };
  EXPECT_EQ(with(two, two), "");
  EXPECT_EQ(with(two, three), "omega_B_z has 3 rows, t has 2");
  EXPECT_EQ(with(endless, two), "t[1]: inf is not a finite number");
  EXPECT_EQ(with(none, two), "no rows");
  EXPECT_EQ(refusal({{"t", two}, {"t", two}}), "column t occurs twice");
  EXPECT_EQ(refusal({{"T [s]", two}}), "no column t; if 'T [s]' is the time, name it t");
  EXPECT_EQ(refusal({{"t", two}, {"omega_B_x", two}}),
            "column omega_B_z is missing; give all of omega_B_x, omega_B_y, omega_B_z");
}

}  // namespace
}  // namespace poinsot::reference
