#include "tests/app/TracedProgram.h"

#include "tests/support/Places.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <linux/ptrace.h>
#include <stdexcept>
#include <sys/ptrace.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <sys/wait.h>
#include <unistd.h>

namespace asperity::test {

namespace {

constexpr int kSystemCall = SIGTRAP | 0x80;  // PTRACE_O_TRACESYSGOOD
constexpr int kAnyThread = __WALL;

struct SystemCall {
    std::uint64_t number = 0;
    std::array<std::uint64_t, 6> arguments{};
};

/// @return whether the thread is at the start of a system call
bool isEntering(pid_t thread, SystemCall& call) {
    struct ptrace_syscall_info info {};
    if (ptrace(static_cast<__ptrace_request>(PTRACE_GET_SYSCALL_INFO), thread, sizeof info,
               &info) <= 0 ||
        info.op != PTRACE_SYSCALL_INFO_ENTRY) {
        return false;
    }
    call.number = info.entry.nr;
    std::copy_n(info.entry.args, call.arguments.size(), call.arguments.begin());
    return true;
}

bool isRegularFile(pid_t process, std::uint64_t descriptor) {
    std::error_code unknown;
    return std::filesystem::is_regular_file(
        "/proc/" + std::to_string(process) + "/fd/" + std::to_string(descriptor), unknown);
}

std::uint64_t bytesOfParts(pid_t thread, const SystemCall& call) {
    constexpr std::size_t kMaxParts = 64;
    std::array<iovec, kMaxParts> parts{};
    const std::size_t count = std::min<std::size_t>(call.arguments[2], kMaxParts);
    const iovec here{parts.data(), count * sizeof(iovec)};
    const iovec there{reinterpret_cast<void*>(call.arguments[1]), count * sizeof(iovec)};
    std::uint64_t bytes = 0;
    if (process_vm_readv(thread, &here, 1, &there, 1, 0) > 0) {
        for (std::size_t i = 0; i < count; ++i) {
            bytes += parts[i].iov_len;
        }
    }
    return bytes;
}

/// What a system call would add.
FileProgress effectOf(pid_t thread, const SystemCall& call) {
    switch (call.number) {
    case SYS_write:
    case SYS_pwrite64:
        return {.bytes = isRegularFile(thread, call.arguments[0]) ? call.arguments[2] : 0};
    case SYS_writev:
    case SYS_pwritev:
        return {.bytes = isRegularFile(thread, call.arguments[0]) ? bytesOfParts(thread, call) : 0};
    case SYS_openat:
        return {.steps = (call.arguments[2] & O_CREAT) != 0 ? 1U : 0U};
#ifdef SYS_open  // not on ARM
    case SYS_open:
        return {.steps = (call.arguments[1] & O_CREAT) != 0 ? 1U : 0U};
    case SYS_mkdir:
    case SYS_rename:
    case SYS_unlink:
    case SYS_rmdir:
#endif
    case SYS_mkdirat:
    case SYS_renameat:
    case SYS_renameat2:
    case SYS_unlinkat:
        return {.steps = 1};
    default:
        return {};
    }
}

[[noreturn]] void become(std::vector<std::string> words,
                         const std::vector<std::string>& environment) {
    for (const std::string& setting : environment) {
        const std::size_t name = setting.find('=');
        setenv(setting.substr(0, name).c_str(), setting.substr(name + 1).c_str(), 1);
    }
    std::vector<char*> pointers;
    for (std::string& word : words) {
        pointers.push_back(word.data());
    }
    pointers.push_back(nullptr);
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    ptrace(PTRACE_TRACEME, 0, nullptr, nullptr);
    raise(SIGSTOP);
    execv(pointers.front(), pointers.data());
    _exit(127);
}

/// The signal that a stopped thread gets when it goes on; 0: none, the stop was the tracer's own.
int signalOf(int status) {
    const int signal = WSTOPSIG(status);
    return signal == kSystemCall || signal == SIGSTOP || status >> 16 != 0 ? 0 : signal;
}

}  // namespace

TracedEnd runTraced(const std::vector<std::string>& arguments,
                    const std::vector<std::string>& environment, const KillPoint& point) {
    std::vector<std::string> words{programOfBuild("asperity").string()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    const pid_t program = fork();
    if (program == 0) {
        become(words, environment);
    }
    int status = 0;
    if (program < 0 || waitpid(program, &status, kAnyThread) != program || !WIFSTOPPED(status) ||
        ptrace(PTRACE_SETOPTIONS, program, nullptr,
               PTRACE_O_TRACESYSGOOD | PTRACE_O_TRACECLONE | PTRACE_O_TRACEEXEC |
                   PTRACE_O_EXITKILL) != 0) {
        throw std::runtime_error("no program can be traced");
    }
    TracedEnd end;
    for (pid_t thread = program;;) {
        const int signal = WIFSTOPPED(status) ? signalOf(status) : 0;
        ptrace(PTRACE_SYSCALL, thread, nullptr, signal);
        thread = waitpid(-1, &status, kAnyThread);
        if (thread < 0 && errno != EINTR) {
            throw std::runtime_error("the traced program is lost");
        }
        if (thread == program && (WIFEXITED(status) || WIFSIGNALED(status))) {
            end.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
            return end;
        }
        SystemCall call;
        if (thread > 0 && WIFSTOPPED(status) && WSTOPSIG(status) == kSystemCall &&
            isEntering(thread, call)) {
            const FileProgress effect = effectOf(thread, call);
            if (end.progress.bytes + effect.bytes > point.bytes ||
                end.progress.steps + effect.steps > point.steps) {
                end.wasKilled = true;
                kill(program, SIGKILL);
                continue;
            }
            end.progress.bytes += effect.bytes;
            end.progress.steps += effect.steps;
        }
    }
}

}  // namespace asperity::test
