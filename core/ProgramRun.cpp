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
#include <spawn.h>
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

/// What a new process changes before the program begins.
class SpawnSettings {
public:
    SpawnSettings(const ProgramCall& call, int output) {
        posix_spawn_file_actions_init(&actions_);
        posix_spawnattr_init(&attributes_);
        posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_adddup2(&actions_, output, STDOUT_FILENO);
        posix_spawn_file_actions_adddup2(&actions_, output, STDERR_FILENO);
        posix_spawn_file_actions_addclosefrom_np(&actions_, STDERR_FILENO + 1);
        posix_spawn_file_actions_addchdir_np(&actions_, call.folder.c_str());
        sigset_t none;
        sigemptyset(&none);
        posix_spawnattr_setsigmask(&attributes_, &none);
        sigset_t usual;
        sigemptyset(&usual);
        for (const int each : {SIGHUP, SIGINT, SIGQUIT, SIGPIPE, SIGTERM, SIGCHLD, SIGXFSZ}) {
            sigaddset(&usual, each);
        }
        posix_spawnattr_setsigdefault(&attributes_, &usual);
        posix_spawnattr_setpgroup(&attributes_, 0);
        posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK |
                                                   POSIX_SPAWN_SETSIGDEF);
    }
    SpawnSettings(const SpawnSettings&) = delete;
    SpawnSettings& operator=(const SpawnSettings&) = delete;
    ~SpawnSettings() {
        posix_spawn_file_actions_destroy(&actions_);
        posix_spawnattr_destroy(&attributes_);
    }

    [[nodiscard]] const posix_spawn_file_actions_t* actions() const { return &actions_; }
    [[nodiscard]] const posix_spawnattr_t* attributes() const { return &attributes_; }

private:
    posix_spawn_file_actions_t actions_{};
    posix_spawnattr_t attributes_{};
};

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

/// A started program, which does not outlive this.
class Child {
public:
    Child(const ProgramCall& call, int output) : call_(call) {
        const SpawnSettings settings(call, output);
        std::vector<std::string> words{call.program.string()};
        words.insert(words.end(), call.arguments.begin(), call.arguments.end());
        std::vector<std::string> environment = call.environment;
        const int error =
            posix_spawn(&process_, call.program.c_str(), settings.actions(), settings.attributes(),
                        pointersTo(words).data(), pointersTo(environment).data());
        if (error != 0) {
            fail(call, "cannot be started", error);
        }
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
    /// Within the first moments of the program; it has not read its input by then.
    void bound() const {
        // Should this program be killed, that one does not go on without end, either.
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
