// SPDX-License-Identifier: Apache-2.0
#include "process/call_filter.h"

#include <sched.h>
#include <seccomp.h>

#include <cerrno>
#include <memory>

#include "core/error.h"

namespace poinsot::process {
namespace {

constexpr int kForbidden[] = {
    // networks
    SCMP_SYS(socket), SCMP_SYS(socketpair), SCMP_SYS(connect), SCMP_SYS(bind), SCMP_SYS(listen), SCMP_SYS(accept),
    SCMP_SYS(accept4),
    // other programs
    SCMP_SYS(execve), SCMP_SYS(execveat), SCMP_SYS(uselib),
    // other processes
    SCMP_SYS(ptrace), SCMP_SYS(process_vm_readv), SCMP_SYS(process_vm_writev), SCMP_SYS(process_madvise),
    SCMP_SYS(pidfd_open), SCMP_SYS(pidfd_getfd), SCMP_SYS(pidfd_send_signal), SCMP_SYS(kcmp), SCMP_SYS(msgget),
    SCMP_SYS(semget), SCMP_SYS(shmget), SCMP_SYS(mq_open),
    // file systems
    SCMP_SYS(mount), SCMP_SYS(umount2), SCMP_SYS(pivot_root), SCMP_SYS(chroot), SCMP_SYS(fsopen),
    SCMP_SYS(fsmount), SCMP_SYS(fspick), SCMP_SYS(fsconfig), SCMP_SYS(move_mount), SCMP_SYS(open_tree),
    SCMP_SYS(mount_setattr), SCMP_SYS(open_by_handle_at), SCMP_SYS(name_to_handle_at), SCMP_SYS(mknod),
    SCMP_SYS(mknodat), SCMP_SYS(symlink), SCMP_SYS(symlinkat), SCMP_SYS(quotactl), SCMP_SYS(swapon),
    SCMP_SYS(swapoff), SCMP_SYS(fanotify_init), SCMP_SYS(setxattr), SCMP_SYS(lsetxattr), SCMP_SYS(fsetxattr),
    // privileges
    SCMP_SYS(unshare), SCMP_SYS(setns), SCMP_SYS(setuid), SCMP_SYS(setgid), SCMP_SYS(setreuid), SCMP_SYS(setregid),
    SCMP_SYS(setresuid), SCMP_SYS(setresgid), SCMP_SYS(setgroups), SCMP_SYS(setfsuid), SCMP_SYS(setfsgid),
    SCMP_SYS(capset), SCMP_SYS(chown), SCMP_SYS(fchown), SCMP_SYS(lchown), SCMP_SYS(fchownat), SCMP_SYS(add_key),
    SCMP_SYS(request_key), SCMP_SYS(keyctl),
    // administration of the machine
    SCMP_SYS(reboot), SCMP_SYS(kexec_load), SCMP_SYS(kexec_file_load), SCMP_SYS(init_module),
    SCMP_SYS(finit_module), SCMP_SYS(delete_module), SCMP_SYS(settimeofday), SCMP_SYS(clock_settime),
    SCMP_SYS(clock_adjtime), SCMP_SYS(adjtimex), SCMP_SYS(sethostname), SCMP_SYS(setdomainname), SCMP_SYS(acct),
    SCMP_SYS(syslog), SCMP_SYS(iopl), SCMP_SYS(ioperm),
    // interfaces with a history of kernel vulnerabilities
    SCMP_SYS(bpf), SCMP_SYS(perf_event_open), SCMP_SYS(userfaultfd), SCMP_SYS(io_uring_setup),
    SCMP_SYS(io_uring_enter), SCMP_SYS(io_uring_register), SCMP_SYS(personality), SCMP_SYS(modify_ldt),
    SCMP_SYS(vmsplice), SCMP_SYS(lookup_dcookie), SCMP_SYS(nfsservctl), SCMP_SYS(memfd_secret)};

struct Release {
  void operator()(scmp_filter_ctx filter) const { seccomp_release(filter); }
};
using Filter = std::unique_ptr<void, Release>;

void expect(int status) {
  if (status < 0)
    throw core::graphicsError("--untrusted: cannot install a filter of system calls: " +
                              core::systemReason(-status));
}

/// Returns a filter that allows every system call. Calls of another CPU architecture kill the process. The caller
/// adds rules for forbidden calls.
Filter makeFilter() {
  Filter filter(seccomp_init(SCMP_ACT_ALLOW));
  expect(filter ? 0 : -ENOMEM);
  expect(seccomp_attr_set(filter.get(), SCMP_FLTATR_ACT_BADARCH, SCMP_ACT_KILL_PROCESS));
  return filter;
}

/// Forbids a call if its argument with number `index` equals `value` in the bits of `mask`.
void forbid(const Filter& filter, int call, unsigned index, scmp_datum_t mask, scmp_datum_t value) {
  expect(seccomp_rule_add(filter.get(), SCMP_ACT_ERRNO(EPERM), call, 1,
                          scmp_arg_cmp{index, SCMP_CMP_MASKED_EQ, mask, value}));
}

}  // namespace

void forbidCalls() {
  const Filter filter = makeFilter();
  for (const int call : kForbidden)
    if (call >= 0) expect(seccomp_rule_add(filter.get(), SCMP_ACT_ERRNO(EPERM), call, 0));  // < 0: not on this CPU
  // ioctl requests that insert characters into the terminal from which the program was started.
  constexpr scmp_datum_t kTypeIn = 0x5412, kPasteIn = 0x541c;  // TIOCSTI, TIOCLINUX
  for (const scmp_datum_t request : {kTypeIn, kPasteIn}) forbid(filter, SCMP_SYS(ioctl), 1, 0xffffffff, request);
  // Disables clone3(), because its flags could create a namespace, and filters cannot read these flags. After
  // ENOSYS, the C library uses clone() instead.
  expect(seccomp_rule_add(filter.get(), SCMP_ACT_ERRNO(ENOSYS), SCMP_SYS(clone3), 0));
  for (const int flag : {CLONE_NEWNS, CLONE_NEWUSER, CLONE_NEWPID, CLONE_NEWNET, CLONE_NEWIPC, CLONE_NEWUTS,
                         CLONE_NEWCGROUP, CLONE_PTRACE}) {
    const auto bit = static_cast<scmp_datum_t>(flag);
    forbid(filter, SCMP_SYS(clone), 0, bit, bit);
  }
  expect(seccomp_load(filter.get()));
}

void forbidProcesses() {
  const Filter filter = makeFilter();
  for (const int call : {SCMP_SYS(fork), SCMP_SYS(vfork)})
    if (call >= 0) expect(seccomp_rule_add(filter.get(), SCMP_ACT_ERRNO(EPERM), call, 0));
  forbid(filter, SCMP_SYS(clone), 0, CLONE_THREAD, 0);
  expect(seccomp_load(filter.get()));
}

}  // namespace poinsot::process
