// SPDX-License-Identifier: Apache-2.0
#include "faults/memory_watch.h"

#include <unistd.h>

#include <algorithm>
#include <csignal>

namespace poinsot::faults {
namespace {

double numberAfterLast(const std::string& text, const std::string& word) {
  const auto at = text.rfind(word);
  return at == std::string::npos ? 0 : std::strtod(text.c_str() + at + word.size(), nullptr);
}

/// Returns a file of /proc for a process; empty if the process has ended.
std::string ofProcess(pid_t process, const std::string& file) {
  std::ifstream stream("/proc/" + std::to_string(process) + "/" + file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

double resident_MiB(pid_t process) { return numberAfterLast(ofProcess(process, "status"), "VmRSS:") / 1024; }

pid_t childOf(pid_t process) {
  return std::atoi(ofProcess(process, "task/" + std::to_string(process) + "/children").c_str());
}

bool hasEnded(pid_t process) {
  const std::string status = ofProcess(process, "status");
  return status.empty() || status.find("State:\tZ") != std::string::npos;
}

}  // namespace

MemoryWatch::Sample MemoryWatch::sampleOf(const ProgramRun& run) {
  const pid_t worker = childOf(run.pid());
  return {static_cast<std::int64_t>(numberAfterLast(run.errSoFar(), "\"done\":")), resident_MiB(run.pid()),
          worker > 0 ? resident_MiB(worker) : 0};
}

MemoryWatch::MemoryWatch(const ScratchFolder& folder, const std::vector<std::string>& arguments) {
  constexpr int kPause_us = 20'000;
  ProgramRun run(folder, arguments);
  while (!hasEnded(run.pid())) {
    samples_.push_back(sampleOf(run));
    usleep(kPause_us);
  }
  samples_.push_back({static_cast<std::int64_t>(numberAfterLast(run.errSoFar(), "\"done\":"))});
  const RunResult made = run.wait();
  EXPECT_EQ(made.exitCode, 0) << made.err.substr(made.err.size() - std::min<std::size_t>(made.err.size(), 500));
}

std::vector<double> MemoryWatch::worker_MiB(std::int64_t from, std::int64_t to) const {
  std::vector<double> all;
  for (const Sample& sample : samples_)
    if (sample.done >= from && sample.done < to) all.push_back(sample.worker_MiB);
  return all;
}

double MemoryWatch::workerPeak_MiB(std::int64_t from, std::int64_t to) const {
  const std::vector<double> all = worker_MiB(from, to);
  return all.empty() ? 0 : std::ranges::max(all);
}

double MemoryWatch::workerMedian_MiB(std::int64_t from, std::int64_t to) const {
  std::vector<double> all = worker_MiB(from, to);
  if (all.empty()) return 0;
  const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
  std::ranges::nth_element(all, middle);
  return *middle;
}

double MemoryWatch::parentPeak_MiB() const {
  return std::ranges::max(samples_, {}, &Sample::parent_MiB).parent_MiB;
}

}  // namespace poinsot::faults
