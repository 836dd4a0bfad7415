#include "tests/app/TracedProgram.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
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
    struct __ptrace_syscall_info info {};
    if (ptrace(PTRACE_GET_SYSCALL_INFO, thread, sizeof info, &info) <= 0 ||
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

/// The path that an argument leads to; empty where it cannot be read.
std::string pathAt(pid_t thread, std::uint64_t address) {
    std::ifstream memory("/proc/" + std::to_string(thread) + "/mem", std::ios::binary);
    memory.seekg(static_cast<std::streamoff>(address));
    std::string path;
    std::getline(memory, path, '\0');
    return path;
}

/// Returns the file that a system call makes; empty: none with a name.
std::string madeBy(pid_t thread, const SystemCall& call) {
    switch (call.number) {
    case SYS_openat:
    case SYS_mkdirat:
        return pathAt(thread, call.arguments[1]);
#ifdef SYS_open  // not on ARM
    case SYS_open:
    case SYS_mkdir:
        return pathAt(thread, call.arguments[0]);
    case SYS_rename:
        return pathAt(thread, call.arguments[1]);
#endif
    case SYS_renameat:
    case SYS_renameat2:
        return pathAt(thread, call.arguments[3]);
    default:
        return {};
    }
}

/// Returns what a system call would add.
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
    setenv("ASAN_OPTIONS", "detect_leaks=0", 1);  // what looks for them traces the program itself
    std::vector<char*> pointers;
    for (std::string& word : words) {
        pointers.push_back(word.data());
    }
    pointers.push_back(nullptr);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        std::signal(signal, SIG_DFL);
    }
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    ptrace(PTRACE_TRACEME, 0, nullptr, nullptr);
    raise(SIGSTOP);
    execv(pointers.front(), pointers.data());
    _exit(127);
}

/// The signal that a stopped thread gets when it continues; 0: none, the stop was the tracer's own.
int signalOf(int status) {
    const int signal = WSTOPSIG(status);
    return signal == kSystemCall || signal == SIGSTOP || status >> 16 != 0 ? 0 : signal;
}

/// A program that stops at each of its system calls.
class Tracee {
public:
    Tracee(const std::vector<std::string>& words, const std::vector<std::string>& environment,
           const SignalPoint& point)
        : point_(point), program_(fork()) {
        if (program_ == 0) {
            become(words, environment);
        }
        if (program_ < 0 || waitpid(program_, &status_, kAnyThread) != program_ ||
            !WIFSTOPPED(status_) ||
            ptrace(PTRACE_SETOPTIONS, program_, nullptr,
                   PTRACE_O_TRACESYSGOOD | PTRACE_O_TRACECLONE | PTRACE_O_TRACEEXEC |
                       PTRACE_O_EXITKILL) != 0) {
            throw std::runtime_error("no program can be traced");
        }
    }

    TracedEnd run() {
        for (pid_t thread = program_;;) {
            const int signal = WIFSTOPPED(status_) ? signalOf(status_) : 0;
            ptrace(PTRACE_SYSCALL, thread, nullptr, signal);
            thread = waitpid(-1, &status_, kAnyThread);
            if (thread < 0 && errno != EINTR) {
                throw std::runtime_error("the traced program is lost");
            }
            if (thread == program_ && (WIFEXITED(status_) || WIFSIGNALED(status_))) {
                end_.exitCode = WIFEXITED(status_) ? WEXITSTATUS(status_) : -1;
                return end_;
            }
            SystemCall call;
            if (thread > 0 && WIFSTOPPED(status_) && WSTOPSIG(status_) == kSystemCall &&
                isEntering(thread, call)) {
                take(thread, call);
            }
        }
    }

private:
    void take(pid_t thread, const SystemCall& call) {
        const FileProgress effect = effectOf(thread, call);
        if (!end_.wasSignaled && isThere(thread, call, effect)) {
            end_.wasSignaled = true;
            kill(program_, point_.signal);
        }
        end_.progress.bytes += effect.bytes;
        end_.progress.steps += effect.steps;
    }

    [[nodiscard]] bool isThere(pid_t thread, const SystemCall& call,
                               const FileProgress& effect) const {
        return end_.progress.bytes + effect.bytes > point_.bytes ||
               end_.progress.steps + effect.steps > point_.steps ||
               (effect.steps > 0 && !point_.made.empty() &&
                madeBy(thread, call).ends_with(point_.made));
    }

    const SignalPoint& point_;
    pid_t program_;
    int status_ = 0;
    TracedEnd end_;
};

}  // namespace

TracedEnd runTraced(const std::vector<std::string>& words,
                    const std::vector<std::string>& environment, const SignalPoint& point) {
    return Tracee(words, environment, point).run();
}

}  // namespace asperity::test
