#include "core/ProgramRun.h"

#include "core/Error.h"
#include "core/FileDescriptor.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <optional>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <system_error>
#include <thread>
#include <unistd.h>

namespace asperity {

namespace {

using Clock = std::chrono::steady_clock;
/// Between looks at whether the program has ended: its output mostly ends at the same moment.
constexpr std::chrono::milliseconds kLook{20};
constexpr std::chrono::milliseconds kShortLook{1};
constexpr int kNoProgram = 127;  ///< exit code of a process that did not become the program

[[noreturn]] void fail(const ProgramCall& call, const char* what, int error) {
    throw Error(call.program.string() + ": the program " + what + ": " +
                std::generic_category().message(error));
}

struct Pipe {
    FileDescriptor reading{-1};
    FileDescriptor writing{-1};
};

Pipe openPipe(const ProgramCall& call) {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) {
        fail(call, "cannot be started", errno);
    }
    Pipe pipe{FileDescriptor(ends[0]), FileDescriptor(ends[1])};
    // This end alone: what the program writes to is as it expects.
    fcntl(pipe.reading.get(), F_SETFL, O_NONBLOCK);
    return pipe;
}

/// Pointers to texts, as exec takes them.
std::vector<char*> pointersTo(std::vector<std::string>& texts) {
    std::vector<char*> pointers;
    pointers.reserve(texts.size() + 1);
    for (std::string& text : texts) {
        pointers.push_back(text.data());
    }
    pointers.push_back(nullptr);
    return pointers;
}

/// Everything that a new process needs to become the program. It must not allocate: until then it
/// may share the memory of this process.
struct Start {
    const char* program;
    char* const* words;
    char* const* environment;
    const char* folder;
    int input;
    int output;
    int failure;    ///< gets the system's number of what fails before
    pid_t starter;  ///< the process that waits for the program
};

/// Ends this process with the one that started it, however that ends: the kernel does, for as long
/// as the thread lives that started it, which waits. Where that is gone already, returns false with
/// `errno` ESRCH.
bool endWith(pid_t starter) {
    if (prctl(PR_SET_PDEATHSIG, SIGKILL) != 0) {
        return false;
    }
    errno = ESRCH;
    return getppid() == starter;
}

/// All signals at their defaults, none blocked. They are blocked until then: a handler would run in
/// the memory of the process that waits.
void resetSignals() {
    struct sigaction usual {};
    usual.sa_handler = SIG_DFL;
    for (int each = 1; each < NSIG; ++each) {
        (void)sigaction(each, &usual, nullptr);  // some cannot be changed
    }
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
}

/// Standard streams and the place for a failure alone stay open. Streams 0 to 2 are open in this
/// process before (openClosedStandardStreams()), so that none of these files has such a number and
/// is overwritten by another one.
bool moveStreams(const Start& start) {
    constexpr int kFailure = STDERR_FILENO + 1;
    if (dup2(start.input, STDIN_FILENO) < 0 || dup2(start.output, STDOUT_FILENO) < 0 ||
        dup2(start.output, STDERR_FILENO) < 0 ||
        (start.failure != kFailure && dup3(start.failure, kFailure, O_CLOEXEC) < 0)) {
        return false;
    }
    closefrom(kFailure + 1);
    return true;
}

[[noreturn]] void becomeProgram(const Start& start) {
    int failure = start.failure;
    if (endWith(start.starter) && setpgid(0, 0) == 0 && chdir(start.folder) == 0 &&
        moveStreams(start)) {
        failure = STDERR_FILENO + 1;
        resetSignals();
        execve(start.program, start.words, start.environment);
    }
    const int error = errno;
    (void)!write(failure, &error, sizeof error);
    _exit(kNoProgram);
}

/// Starts a process that becomes the program. As posix_spawn() does, but that cannot have it end
/// with this process. No memory is copied, however large, and this thread waits until then.
/// @return its number; negative where there is none
pid_t startProcess(const Start& start) {
    sigset_t all;
    sigset_t before;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, &before);
    const pid_t process = vfork();  // NOLINT(clang-analyzer-security.insecureAPI.vfork)
    if (process == 0) {
        becomeProgram(start);
    }
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    return process;
}

/// A started program, which does not outlive this.
class Child {
public:
    Child(const ProgramCall& call, int output) : call_(call) {
        std::vector<std::string> words{call.program.string()};
        words.insert(words.end(), call.arguments.begin(), call.arguments.end());
        std::vector<std::string> environment = call.environment;
        const std::vector<char*> wordPointers = pointersTo(words);
        const std::vector<char*> environmentPointers = pointersTo(environment);
        const FileDescriptor input(open("/dev/null", O_RDONLY | O_CLOEXEC));
        if (!input.isOpen()) {
            fail(call, "cannot be started", errno);
        }
        Pipe failure = openPipe(call);
        process_ = startProcess({.program = call.program.c_str(),
                                 .words = wordPointers.data(),
                                 .environment = environmentPointers.data(),
                                 .folder = call.folder.c_str(),
                                 .input = input.get(),
                                 .output = output,
                                 .failure = failure.writing.get(),
                                 .starter = getpid()});
        if (process_ < 0) {
            fail(call, "cannot be started", errno);
        }
        requireStarted(failure);
        bound();
    }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;
    ~Child() { (void)end(); }

    /// Whether the program has ended by itself. It stays a zombie, so that its number is its own.
    [[nodiscard]] bool hasEnded() {
        siginfo_t status{};
        if (waitid(P_PID, static_cast<id_t>(process_), &status, WEXITED | WNOHANG | WNOWAIT) == 0) {
            return status.si_pid == process_;
        }
        if (errno == EINTR) {
            return false;
        }
        const int error = errno;
        process_ = -1;  // another part of this program has waited for it
        fail(call_, "cannot be waited for", error);
    }

    /// Ends what is left of the group. @return the program's wait status
    int end() noexcept {
        int status = 0;
        if (process_ > 0) {
            kill(-process_, SIGKILL);
            while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
            }
            process_ = -1;
        }
        return status;
    }

private:
    /// @param failure is closed when the process has become the program
    void requireStarted(Pipe& failure) {
        failure.writing = FileDescriptor(-1);
        pollfd waited{.fd = failure.reading.get(), .events = POLLIN, .revents = 0};
        while (poll(&waited, 1, -1) < 0 && errno == EINTR) {
        }
        int error = 0;
        if (read(failure.reading.get(), &error, sizeof error) == sizeof error) {
            (void)end();
            fail(call_, "cannot be started", error);
        }
    }

    /// Within the first moments of the program; it has not read its input by then.
    void bound() const {
        // With this program the kernel ends that one alone: what it has started ends by this limit.
        const auto seconds = std::chrono::ceil<std::chrono::seconds>(call_.deadline - Clock::now());
        limit(RLIMIT_CPU, static_cast<std::uint64_t>(std::max<long>(seconds.count(), 0)) + 1);
        limit(RLIMIT_FSIZE, call_.maxFile);
        limit(RLIMIT_AS, call_.maxMemory);
        limit(RLIMIT_CORE, 0);
    }

    void limit(__rlimit_resource resource, std::uint64_t most) const {
        struct rlimit now {};
        if (prlimit(process_, resource, nullptr, &now) == 0) {
            const rlimit lower{std::min<rlim_t>(now.rlim_cur, most),
                               std::min<rlim_t>(now.rlim_max, most)};
            (void)prlimit(process_, resource, &lower, nullptr);
        }
    }

    const ProgramCall& call_;
    pid_t process_ = -1;
};

/// Moves what the program has written until now. @return whether more may come
bool takeOutput(FileDescriptor& from, std::string& output, std::uint64_t most) {
    std::array<char, 16384> block{};
    while (output.size() <= most) {
        const ssize_t count = read(from.get(), block.data(), block.size());
        if (count > 0) {
            output.append(block.data(), static_cast<std::size_t>(count));
        } else if (count == 0 || (errno != EINTR && errno != EAGAIN)) {
            return false;
        } else if (errno == EAGAIN) {
            return true;
        }
    }
    return true;
}

/// Until something was written or it is time for a look.
void waitForOutput(const FileDescriptor& from, Clock::time_point deadline) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now());
    const auto time = std::clamp(left, std::chrono::milliseconds{0}, kLook);
    pollfd waited{.fd = from.get(), .events = POLLIN, .revents = 0};
    (void)poll(&waited, 1, static_cast<int>(time.count()));
}

/// @return how it ended; empty: by itself
std::optional<ProgramEnd> follow(const ProgramCall& call, Child& child, FileDescriptor& from,
                                 std::string& output) {
    bool isOpen = true;
    for (bool ended = false; !ended;) {
        if (Clock::now() >= call.deadline) {
            return ProgramEnd::TimedOut;
        }
        if (isOpen) {
            waitForOutput(from, call.deadline);
        } else {
            std::this_thread::sleep_for(kShortLook);
        }
        ended = child.hasEnded();
        isOpen = isOpen && takeOutput(from, output, call.maxOutput);
        if (output.size() > call.maxOutput) {
            return ProgramEnd::WroteTooMuch;
        }
    }
    return std::nullopt;
}

}  // namespace

ProgramOutcome runProgram(const ProgramCall& call) {
    Pipe pipe = openPipe(call);
    Child child(call, pipe.writing.get());
    pipe.writing = FileDescriptor(-1);
    ProgramOutcome outcome;
    const std::optional<ProgramEnd> cut = follow(call, child, pipe.reading, outcome.output);
    const int status = child.end();
    if (cut) {
        outcome.end = *cut;
    } else if (WIFEXITED(status)) {
        outcome.exitCode = WEXITSTATUS(status);
    } else {
        outcome.end = ProgramEnd::Killed;
    }
    return outcome;
}

}  // namespace asperity
