// SPDX-License-Identifier: Apache-2.0
#include "faults/submitted_film.h"

#include "faults/tiny_film.h"
#include "support/program_run.h"

namespace poinsot::faults {
SubmittedFilm::SubmittedFilm(const std::string& folder) : folder_(scratch_ / folder) {
  put("tiny.toml", kTinyScene);
  // The program runs in its own session; otherwise the kill would also end the task's script.
  scratch_.put(
      "dying",
      "#!/bin/bash\n"
      "here=$(dirname -- \"$0\")\n"
      "[[ $1 == assemble ]] && rm -- \"$here/nojoin\" 2>/dev/null && exit 4\n"
      "case $* in *\" --shard $(cat -- \"$here/shard\" 2>/dev/null)/\"*)\n"
      "  if [[ -e $here/hang ]]; then\n"
      "    rm -- \"$here/hang\" \"$here/shard\"\n"
      "    touch -- \"$here/died\"\n"
      "    exec sleep 300\n"
      "  fi\n"
      "  [[ -e $here/once && -e $here/died ]] ||\n"
      "    exec setsid -w env LD_PRELOAD=" POINSOT_FAULT_INJECTOR
      " FAULT_CALL=rename FAULT_KIND=kill FAULT_AT=$(cat -- \"$here/at\") FAULT_ROLE=worker FAULT_FOLDER=\"$PWD\" "
      "FAULT_MARK=\"$here/died\" " POINSOT_PROGRAM
      " \"$@\" ;;\n"
      "esac\n"
      "exec " POINSOT_PROGRAM " \"$@\"\n");
  std::filesystem::permissions(scratch_ / "dying", std::filesystem::perms::owner_all);
}

void SubmittedFilm::put(const std::string& name, const std::string& text) const {
  std::filesystem::create_directories((folder_ / name).parent_path());
  std::ofstream(folder_ / name) << text;
}

void SubmittedFilm::writeScript(const std::string& engine, const std::string& more) const {
  const ShellResult made = shell("$poinsot submit tiny.toml -o film.mp4 --size 64x36 --segment 3 --shards " +
                                 std::to_string(kTasks) + " --engine " + engine + " " + more + " >\"$script\"");
  EXPECT_EQ(made.exitCode, 0) << made.out;
}

ShellResult SubmittedFilm::shell(const std::string& commands, const std::vector<std::string>& environment) const {
  const std::string settings = "script='" + (scratch_ / "script").string() + "'\npoinsot=" POINSOT_PROGRAM "\n";
  return runShell(folder_, settings + commands, environment);
}

void SubmittedFilm::breakShard(int k, bool onlyOnce) const {
  std::filesystem::remove(scratch_ / "died");
  scratch_.put("shard", std::to_string(k));
  scratch_.put("at", onlyOnce ? "3" : "1");  // a segment and its record take one rename each
  if (onlyOnce) scratch_.put("once", "");
}

void SubmittedFilm::breakJoining() const { scratch_.put("nojoin", ""); }

void SubmittedFilm::hangShard(int k) const {
  std::filesystem::remove(scratch_ / "died");
  scratch_.put("shard", std::to_string(k));
  scratch_.put("hang", "");
}

void SubmittedFilm::repair() const { std::filesystem::remove(scratch_ / "shard"); }

bool SubmittedFilm::died() const { return std::filesystem::exists(scratch_ / "died"); }

bool SubmittedFilm::waitUntilDied(double most_s) const {
  for (const Watch watch; !died() && watch.seconds() < most_s;) usleep(50'000);
  return died();
}

bool SubmittedFilm::hasFilm() const { return std::filesystem::exists(folder_ / "film.mp4"); }

void SubmittedFilm::expectTheBytesOfALocalRun(const std::string& said) {
  ASSERT_TRUE(hasFilm()) << said;
  EXPECT_TRUE(bytesOf(folder_ / "film.mp4") == localFilm()) << said;
}

std::string SubmittedFilm::localFilm() {
  const ScratchFolder elsewhere;
  elsewhere.put("tiny.toml", kTinyScene);
  const Watch watch;
  const RunResult made = run(elsewhere, {"render", "tiny.toml", "-o", "local.mp4", "--size", "64x36", "--segment",
                                         "3", "--reproducible"});
  local_s_ = watch.seconds();
  EXPECT_EQ(made.exitCode, 0) << made.err;
  return bytesOf(elsewhere / "local.mp4");
}

}  // namespace poinsot::faults
