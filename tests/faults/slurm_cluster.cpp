// SPDX-License-Identifier: Apache-2.0
#include "faults/slurm_cluster.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <pwd.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/wait.h>

#include <chrono>
#include <regex>
#include <stdexcept>

namespace poinsot::faults {
namespace {

std::vector<int> freePorts(int count) {
  std::vector<int> sockets, ports;
  for (int i = 0; i < count; ++i) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    const int fd = socket(AF_INET, SOCK_STREAM, 0);
    if (fd < 0 || bind(fd, reinterpret_cast<sockaddr*>(&address), size) != 0 ||
        getsockname(fd, reinterpret_cast<sockaddr*>(&address), &size) != 0)
      throw std::runtime_error("no free port");
    sockets.push_back(fd);
    ports.push_back(ntohs(address.sin_port));
  }
  for (const int fd : sockets) close(fd);
  return ports;
}

std::string thisHost() {
  char name[256] = {};
  gethostname(name, sizeof name - 1);
  return std::string(name).substr(0, std::string(name).find('.'));
}

double now_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

template <class Condition>
bool waitFor(double most_s, const Condition& holds) {
  for (const double end_s = now_s() + most_s; now_s() < end_s; usleep(100'000))
    if (holds()) return true;
  return false;
}

}  // namespace

SlurmCluster::SlurmCluster() {
  writeSettings();
  start("slurmctld -D -c");
  start("slurmd -D -N n1");
  start("slurmd -D -N n2");
  if (!waitFor(30, [&] { return run("sinfo -h -o %T%D").out == "idle2\n"; }))
    throw std::runtime_error("Slurm does not come up:\n" + logs());
}

SlurmCluster::~SlurmCluster() {
  run("scancel --full --signal=KILL -u $(id -u)");
  for (const pid_t pid : daemons_) kill(pid, SIGTERM);
  for (const pid_t pid : daemons_) {
    waitFor(5, [&] { return waitpid(pid, nullptr, WNOHANG) != 0; });
    kill(-pid, SIGKILL);  // kills processes left by a daemon; their group has the daemon's number
  }
}

bool SlurmCluster::isInstalled() {
  return poinsot::isInstalled("slurmctld") && poinsot::isInstalled("slurmd") && poinsot::isInstalled("sbatch");
}

std::vector<std::string> SlurmCluster::environment(const std::vector<std::string>& more) const {
  std::vector<std::string> all{"SLURM_CONF=" + (folder_ / "slurm.conf").string()};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

ShellResult SlurmCluster::run(const std::string& command) const {
  return runShell(folder_.path(), command, environment());
}

bool SlurmCluster::waitUntil(const std::string& command, double most_s) const {
  return waitFor(most_s, [&] { return run(command).exitCode == 0; });
}

bool SlurmCluster::waitUntilEmpty(double most_s) const {
  return waitUntil("queue=$(squeue -h) && [[ -z $queue ]]", most_s);
}

std::vector<int> SlurmCluster::restarts(int tasks) const {
  std::vector<int> counts(static_cast<std::size_t>(tasks), -1);
  const std::string jobs = run("scontrol -o show job").out;
  const std::regex line("ArrayTaskId=([0-9]+) .* Restarts=([0-9]+) ");
  for (std::sregex_iterator at(jobs.begin(), jobs.end(), line), end; at != end; ++at)
    counts.at(static_cast<std::size_t>(std::stoi((*at)[1]) - 1)) = std::stoi((*at)[2]);
  return counts;
}

/// AuthInfo sets the wait of a requeued job: two minutes by default, at least 5 s. sched_interval sets how often
/// Slurm looks for such jobs: every minute by default.
void SlurmCluster::writeSettings() const {
  const std::vector<int> ports = freePorts(3);
  const std::string folder = folder_.path().string(), user = getpwuid(getuid())->pw_name;
  const auto node = [&](int k) {
    const std::string name = "n" + std::to_string(k);
    return "NodeName=" + name + " NodeHostname=" + name + " NodeAddr=127.0.0.1 CPUs=2 RealMemory=8000 Port=" +
           std::to_string(ports.at(static_cast<std::size_t>(k))) + "\n";
  };
  folder_.put("slurm.conf",
              "ClusterName=poinsot\n"
              "SlurmctldHost=" +
                  thisHost() +
                  "(127.0.0.1)\n"
                  "SlurmctldPort=" +
                  std::to_string(ports[0]) +
                  "\n"
                  "SlurmUser=" +
                  user +
                  "\n"
                  "SlurmdUser=" +
                  user +
                  "\n"
                  "AuthType=auth/none\n"
                  "CredType=cred/none\n"
                  "AuthInfo=cred_expire=5\n"
                  "ProctrackType=proctrack/pgid\n"
                  "TaskPlugin=task/none\n"
                  "SwitchType=switch/none\n"
                  "MpiDefault=none\n"
                  "JobAcctGatherType=jobacct_gather/none\n"
                  "AccountingStorageType=accounting_storage/none\n"
                  "SelectType=select/cons_tres\n"
                  "SelectTypeParameters=CR_CPU_Memory\n"
                  "SchedulerType=sched/builtin\n"
                  "SchedulerParameters=sched_interval=1,batch_sched_delay=1\n"
                  "KillWait=2\n"
                  "ReturnToService=2\n"
                  "StateSaveLocation=" +
                  folder +
                  "/state\n"
                  "SlurmdSpoolDir=" +
                  folder +
                  "/spool.%n\n"
                  "SlurmctldPidFile=" +
                  folder +
                  "/slurmctld.pid\n"
                  "SlurmdPidFile=" +
                  folder + "/slurmd.%n.pid\n" + node(1) + node(2) +
                  "PartitionName=all Nodes=n1,n2 Default=YES MaxTime=60 State=UP\n");
}

/// Starts a daemon in its own process group; its output goes to a file.
void SlurmCluster::start(const std::string& command) {
  const std::string log = (folder_ / ("daemon" + std::to_string(daemons_.size()) + ".log")).string();
  const std::string line = "PATH=$PATH:/usr/sbin exec " + command + " >" + log + " 2>&1 </dev/null";
  const auto settings = environment();
  const pid_t pid = fork();
  if (pid == 0) {
    setpgid(0, 0);
    for (const std::string& setting : settings) putenv(const_cast<char*>(setting.c_str()));
    execlp("bash", "bash", "-c", line.c_str(), nullptr);
    _exit(126);
  }
  if (pid < 0) throw std::runtime_error("no process");
  daemons_.push_back(pid);
}

std::string SlurmCluster::logs() const { return run("tail -n 5 *.log").out; }

}  // namespace poinsot::faults
