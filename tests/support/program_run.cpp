// SPDX-License-Identifier: Apache-2.0
#include "support/program_run.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace poinsot {
namespace {

constexpr const char* kOutName = ".harness-out";
constexpr const char* kErrName = ".harness-err";

int openOutput(const std::filesystem::path& file) {
  return open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
}

int openStdout(const std::filesystem::path& file, Stdout to) {
  if (to == Stdout::kFull) return open("/dev/full", O_WRONLY | O_CLOEXEC);
  if (to != Stdout::kBrokenPipe && to != Stdout::kUnread) return openOutput(file);
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  if (to == Stdout::kBrokenPipe) close(ends[0]);  // the write end stays open until the test ends
  return ends[1];
}

/// Returns the program and its arguments, after the words of POINSOT_RUN_UNDER if that is set (valgrind and its
/// options): see docs/testing.md.
std::vector<std::string> commandLine(const std::vector<std::string>& arguments) {
  const char* under = std::getenv("POINSOT_RUN_UNDER");
  std::istringstream stream(under ? under : "");
  std::vector<std::string> words{std::istream_iterator<std::string>(stream), {}};
  words.emplace_back(POINSOT_PROGRAM);
  words.insert(words.end(), arguments.begin(), arguments.end());
  return words;
}

}  // namespace

const char* const kGoodScene =
    "schema = 1\n"
    "[body]\n"
    "principal_moments = [1, 2, 3]\n"
    "[motion]\n"
    "omega_body = [0.1, 10, 0]\n"
    "[time]\n"
    "duration = 4\n"
    "[output]\n"
    "size = [160, 90]\n";

ProgramRun::ProgramRun(const ScratchFolder& folder, const std::vector<std::string>& arguments, Stdout stdoutTo,
                       const std::vector<std::string>& environment)
    : out_(folder / kOutName), err_(folder / kErrName) {
  std::vector<std::string> line = commandLine(arguments);
  std::vector<char*> words;
  for (std::string& word : line) words.push_back(word.data());
  words.push_back(nullptr);
  const int out = openStdout(out_, stdoutTo), err = openOutput(err_);
  pid_ = fork();
  if (pid_ == 0) {
    setpgid(0, 0);
    ::signal(SIGPIPE, SIG_DFL);
    dup2(err, STDERR_FILENO);
    dup2(out, STDOUT_FILENO);
    if (stdoutTo == Stdout::kClosed) close(STDOUT_FILENO);
    for (const std::string& setting : environment) putenv(const_cast<char*>(setting.c_str()));
    if (chdir(folder.path().c_str()) == 0) execvp(words[0], words.data());
    _exit(126);
  }
  close(out);
  close(err);
  if (pid_ < 0) throw std::runtime_error("no process");
}

ProgramRun::~ProgramRun() {
  if (pid_ <= 0) return;
  kill(-pid_, SIGKILL);
  waitpid(pid_, nullptr, 0);
}

void ProgramRun::signal(int number) const { kill(pid_, number); }

std::string ProgramRun::errSoFar() const { return bytesOf(err_); }

RunResult ProgramRun::wait() {
  int status = 0;
  waitpid(pid_, &status, 0);
  pid_ = -1;
  const std::string out = std::filesystem::exists(out_) ? bytesOf(out_) : "";
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status), out, bytesOf(err_)};
}

RunResult run(const ScratchFolder& folder, const std::vector<std::string>& arguments, Stdout stdoutTo,
              const std::vector<std::string>& environment) {
  return ProgramRun(folder, arguments, stdoutTo, environment).wait();
}

std::string bytesOf(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  EXPECT_TRUE(stream.good()) << file;
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<std::string> namesIn(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name != kOutName && name != kErrName) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace poinsot
