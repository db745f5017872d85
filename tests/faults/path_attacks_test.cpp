// SPDX-License-Identifier: Apache-2.0
// A stranger's scene names files outside its folder. For every name, the program exits with 2 and gives the place
// of the name. strace, which sees every system call, finds no file opened outside the scene's folder and no
// process started.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/sysmacros.h>
#include <sys/un.h>
#include <unistd.h>

#include <atomic>
#include <regex>
#include <sstream>
#include <thread>

#include "support/program_run.h"
#include "support/sanitized.h"
#include "support/shell_run.h"

namespace poinsot::faults {
namespace {

namespace fs = std::filesystem;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

constexpr const char* kTable = "t,Nx,Ny,Nz\n0,0,0,1\n1,0,0,0\n";

std::string quoted(const std::string& text) {
  std::string toml = "\"";
  for (const char c : text) {
    char code[8];
    std::snprintf(code, sizeof code, "\\u%04x", static_cast<unsigned char>(c));
    toml += static_cast<unsigned char>(c) < 0x20 || c == '"' || c == '\\' ? code : std::string(1, c);
  }
  return toml + "\"";
}

class PathAttacks : public testing::Test {
 protected:
  PathAttacks() : scene_(folder_ / "scene") {
    fs::create_directories(scene_ / "below");
    fs::create_directories(folder_ / "outside");
    put("outside/secret.csv", kTable);
    put("secret.csv", kTable);
    put("scene/good.csv", kTable);
    put("scene/below/secret.csv.txt", kTable);
    fs::create_symlink("../secret.csv", scene_ / "link.csv");
    fs::create_symlink("/etc/passwd", scene_ / "passwd.csv");
    fs::create_symlink("link.csv", scene_ / "chain.csv");
    fs::create_symlink("good.csv", scene_ / "inner.csv");
    fs::create_symlink("nowhere", scene_ / "dangling.csv");
    fs::create_directory_symlink("..", scene_ / "up");
    fs::create_directory_symlink("/proc", scene_ / "proc");
    fs::create_directory_symlink("below", scene_ / "down");
    mkfifo((scene_ / "fifo.csv").c_str(), 0600);
    makeSocket(scene_ / "socket.csv");
    if (mknod((scene_ / "zero.csv").c_str(), S_IFCHR | 0600, makedev(1, 5)) != 0)  // mknod requires root
      mkfifo((scene_ / "zero.csv").c_str(), 0600);
  }

  void put(const std::string& name, const std::string& text) const { folder_.put(name, text); }

  static void makeSocket(const fs::path& path) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    path.native().copy(address.sun_path, sizeof address.sun_path - 1);
    const int fd = socket(AF_UNIX, SOCK_STREAM, 0);
    bind(fd, reinterpret_cast<const sockaddr*>(&address), sizeof address);
    close(fd);
  }

  std::vector<std::string> names() const {
    return {"../secret.csv",
            "../../secret.csv",
            "../outside/secret.csv",
            "./../secret.csv",
            "below/../../secret.csv",
            "below/../good.csv",
            "/etc/passwd",
            "//etc/passwd",
            (folder_ / "secret.csv").string(),
            (scene_ / "good.csv").string(),
            "/proc/self/environ",
            "/proc/self/fd/0",
            "/dev/zero",
            "/dev/stdin",
            "link.csv",
            "passwd.csv",
            "chain.csv",
            "inner.csv",
            "dangling.csv",
            "up/secret.csv",
            "proc/self/environ",
            "down/secret.csv.txt",
            "fifo.csv",
            "socket.csv",
            "zero.csv",
            "below",
            ".",
            "",
            "good.csv/",
            "file:good.csv",
            "file:///etc/passwd",
            "FILE://localhost/etc/passwd",
            "http://127.0.0.1/good.csv",
            "%2e%2e/secret.csv",
            "..%2fsecret.csv",
            "..\\secret.csv",
            "~/secret.csv",
            "~root/.profile",
            "$HOME/secret.csv",
            "${PWD}/../secret.csv",
            "$(touch pwned)",
            "`touch pwned`",
            "|touch pwned",
            "good.csv; touch pwned",
            std::string("good.csv\0.txt", 13),
            std::string("../secret.csv\0good.csv", 22),
            "good.csv\n",
            "\x1b[2Jgood.csv",
            std::string(5000, 'x'),
            std::string(199, 'x'),
            "GOOD.CSV",
            "Good.csv",
            "good.csv.",
            "good.csv ",
            " good.csv"};
  }

  void putScene(const std::string& key, const std::string& name) const {
    put("scene/scene.toml",
        "schema = 1\n[body]\nprincipal_moments = [1, 2, 3]\n[motion]\nomega_body = [0.1, 10, 0]\n" + key + " = " +
            quoted(name) + "\n");
  }

  const ScratchFolder folder_;
  const fs::path scene_;
};

/// Files opened and processes started after the scene was opened, as strace and /proc report them.
struct Seen {
  std::vector<std::string> opened, processes;
};

Seen seenIn(const std::string& trace, const std::string& scene) {
  Seen seen;
  std::istringstream lines(trace);
  bool reading = false;
  const std::regex opening(R"(\bopen\w*\(.*= [0-9]+<(.*)>$)");
  const std::regex starting(R"(\b(execve|execveat|fork|vfork|clone|clone3)\()");
  for (std::string line; std::getline(lines, line);) {
    std::smatch found;
    const bool open = std::regex_search(line, found, opening);
    if (reading && open) seen.opened.push_back(found[1]);
    if (std::regex_search(line, starting)) seen.processes.push_back(line);
    reading |= open && found[1] == scene;
  }
  return seen;
}

const char* const kKeys[] = {"torque.file", "style.file"};

TEST_F(PathAttacks, AreRejectedWithoutOpeningAFileOutside) {
  POINSOT_NOT_SANITIZED("strace watches, and one process cannot be watched by two");
  ASSERT_TRUE(isInstalled("strace")) << "apt-get install strace";
  const std::string scene = fs::canonical(scene_).string();
  int refused = 0, outside = 0, processes = 0;
  for (const std::string& name : names())
    for (const std::string key : kKeys) {
      putScene(key == "style.file" ? "[style]\nfile" : "torque.file", name);
      const ShellResult result =
          runShell(folder_.path(), "exec strace -f -y -s 9999 -e trace=%file,%process -o trace " POINSOT_PROGRAM
                                   " check scene/scene.toml < /dev/null");
      SCOPED_TRACE(quoted(name) + ": " + result.out.substr(0, 500));
      EXPECT_EQ(result.exitCode, 2);
      EXPECT_THAT(result.out, ContainsRegex("^scene/scene.toml:[67]:[0-9]+: error: (motion.torque|style).file: "));
      refused += result.exitCode == 2 ? 1 : 0;
      const Seen seen = seenIn(bytesOf(folder_ / "trace"), scene + "/scene.toml");
      for (const std::string& file : seen.opened)
        if (file != scene && !file.starts_with(scene + "/")) {
          ++outside;
          ADD_FAILURE() << "opened " << file;
        }
      processes += static_cast<int>(seen.processes.size()) - 1;  // the program's own start
      EXPECT_EQ(seen.processes.size(), 1u) << testing::PrintToString(seen.processes);
    }
  const int tried = 2 * static_cast<int>(names().size());
  RecordProperty("refused", std::to_string(refused) + " of " + std::to_string(tried));
  EXPECT_GE(tried, 2 * 40);
  EXPECT_EQ(refused, tried);
  EXPECT_EQ(outside, 0);
  EXPECT_EQ(processes, 0);
  EXPECT_FALSE(fs::exists(scene_ / "pwned") || fs::exists(folder_ / "pwned"));
}

// Control: strace reports a file that is read.
TEST_F(PathAttacks, StraceReportsAFileThatIsRead) {
  POINSOT_NOT_SANITIZED("strace watches, and one process cannot be watched by two");
  putScene("torque.file", "good.csv");
  const ShellResult result =
      runShell(folder_.path(),
               "exec strace -f -y -e trace=%file,%process -o trace " POINSOT_PROGRAM " check scene/scene.toml");
  EXPECT_EQ(result.exitCode, 0) << result.out;
  const std::string scene = fs::canonical(scene_).string();
  EXPECT_THAT(seenIn(bytesOf(folder_ / "trace"), scene + "/scene.toml").opened,
              testing::Contains(scene + "/good.csv"));
}

// A folder without the file, and a link to a folder with the file, swap places all the time.
TEST_F(PathAttacks, ReadNoOutsideFileInARace) {
  put("outside/race.csv", "this is outside\n");
  fs::create_directories(scene_ / "race");
  fs::create_directory_symlink("../outside", scene_ / "other");
  putScene("torque.file", "race/race.csv");
  std::atomic<bool> done = false;
  std::jthread mischief([&] {
    constexpr unsigned int kExchange = 2;
    while (!done)
      syscall(SYS_renameat2, AT_FDCWD, (scene_ / "race").c_str(), AT_FDCWD, (scene_ / "other").c_str(), kExchange);
  });
  int asLink = 0, asMissing = 0;
  for (int i = 0; i < 60; ++i) {
    const RunResult result = run(folder_, {"check", "scene/scene.toml"});
    EXPECT_EQ(result.exitCode, 2) << result.err;
    EXPECT_THAT(result.err, Not(HasSubstr("expected four numbers"))) << "it was read";
    asLink += result.err.find("symbolic link") != std::string::npos ? 1 : 0;
    asMissing += result.err.find("No such file") != std::string::npos ? 1 : 0;
  }
  done = true;
  EXPECT_EQ(asLink + asMissing, 60);
  EXPECT_GT(asLink, 0);
  EXPECT_GT(asMissing, 0);
}

}  // namespace
}  // namespace poinsot::faults
