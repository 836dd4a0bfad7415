#include "core/ProgramRun.h"

#include "core/Error.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <fcntl.h>
#include <limits>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace asperity {

namespace {

using Clock = std::chrono::steady_clock;
/// Between looks at whether the program has ended: its output mostly ends at the same moment.
constexpr std::chrono::milliseconds kLook{20};
constexpr std::chrono::milliseconds kShortLook{1};
constexpr int kNoProgram = 127;  ///< exit code of a process that did not become the program

[[noreturn]] void fail(const ProgramCall& call, const char* what, int error) {
    throw Error("the program " + call.program.string() + " " + what + ": " +
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

/// Pointers to texts, for exec.
std::vector<char*> pointersTo(std::vector<std::string>& texts) {
    std::vector<char*> pointers;
    pointers.reserve(texts.size() + 1);
    for (std::string& text : texts) {
        pointers.push_back(text.data());
    }
    pointers.push_back(nullptr);
    return pointers;
}

constexpr std::size_t kStreams = 4;  ///< descriptors 0 to 3: input, output, errors, replies

/// Everything that a new process needs to become the program. It must not allocate: until then it
/// may share the memory of this process.
struct Start {
    const char* program;
    char* const* words;
    char* const* environment;
    const char* folder;                 ///< empty: that of this process
    std::array<int, kStreams> streams;  ///< become its first descriptors; -1: closed
    int failure;                        ///< gets the system's number of what fails before
    int endSignal;
    pid_t starter;  ///< the process that waits for the program
};

/// Ends this process with the one that started it, however that ends: the kernel does, when the
/// thread ends that started it. Where that has ended already, returns false with `errno` ESRCH.
bool endWith(pid_t starter, int signal) {
    if (prctl(PR_SET_PDEATHSIG, signal) != 0) {
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

/// The program's streams and the one for a failure alone stay open. Streams 0 to 2 are open in
/// this process before (openClosedStandardStreams()), so that a file has the number of a stream
/// only where it is that stream or the last one.
/// @param failure is moved behind the streams
bool moveStreams(const Start& start, int& failure) {
    constexpr int kFailure = kStreams;
    failure = fcntl(start.failure, F_DUPFD_CLOEXEC, kFailure);
    if (failure < 0) {
        failure = start.failure;
        return false;
    }
    for (int stream = 0; stream < kFailure; ++stream) {
        const int source = start.streams[static_cast<std::size_t>(stream)];
        if (source < 0) {
            close(stream);
        } else if (source == stream ? fcntl(stream, F_SETFD, 0) < 0 : dup2(source, stream) < 0) {
            return false;
        }
    }
    if (failure != kFailure && dup3(failure, kFailure, O_CLOEXEC) < 0) {
        return false;
    }
    failure = kFailure;
    closefrom(kFailure + 1);
    return true;
}

[[noreturn]] void becomeProgram(const Start& start) {
    int failure = start.failure;
    if (endWith(start.starter, start.endSignal) && setpgid(0, 0) == 0 &&
        (start.folder[0] == '\0' || chdir(start.folder) == 0) && moveStreams(start, failure)) {
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

/// The process of a call with the streams that are given.
/// @throw Error when it cannot be made
pid_t started(const ProgramCall& call, const std::array<int, kStreams>& streams, int failure) {
    std::vector<std::string> words{call.program.string()};
    words.insert(words.end(), call.arguments.begin(), call.arguments.end());
    std::vector<std::string> environment = call.environment;
    const std::vector<char*> wordPointers = pointersTo(words);
    const std::vector<char*> environmentPointers = pointersTo(environment);
    const pid_t process = startProcess({.program = call.program.c_str(),
                                        .words = wordPointers.data(),
                                        .environment = environmentPointers.data(),
                                        .folder = call.folder.c_str(),
                                        .streams = streams,
                                        .failure = failure,
                                        .endSignal = call.endSignal,
                                        .starter = getpid()});
    if (process < 0) {
        fail(call, "cannot be started", errno);
    }
    return process;
}

/// @param failure of which the writing end is closed
/// @return the number of what kept the process from becoming the program; 0: it has become it
int failureOf(const FileDescriptor& failure) {
    pollfd waited{.fd = failure.get(), .events = POLLIN, .revents = 0};
    while (poll(&waited, 1, -1) < 0 && errno == EINTR) {
    }
    int error = 0;
    return read(failure.get(), &error, sizeof error) == sizeof error ? error : 0;
}

/// @param grace between the bound that a signal reports and the one that ends the process
void limit(pid_t process, __rlimit_resource resource, std::uint64_t most, std::uint64_t grace = 0) {
    struct rlimit now {};
    if (prlimit(process, resource, nullptr, &now) == 0) {
        const rlimit lower{std::min<rlim_t>(now.rlim_cur, most),
                           std::min<rlim_t>(now.rlim_max, most + grace)};
        (void)prlimit(process, resource, &lower, nullptr);
    }
}

/// Within the first moments of the program; it has not read its input by then.
void bound(pid_t process, const ProgramCall& call) {
    // With this program the kernel ends that one alone: what it has started ends by this limit.
    const auto left = std::chrono::ceil<std::chrono::seconds>(call.deadline - Clock::now());
    const long seconds =
        std::min(std::max<long>(left.count(), 0) + 1, call.maxProcessorTime.count());
    // The first bound ends it by SIGXCPU, which says why; the second does where it ignores that.
    limit(process, RLIMIT_CPU, static_cast<std::uint64_t>(seconds), 1);
    limit(process, RLIMIT_FSIZE, call.maxFile);
    limit(process, RLIMIT_AS, call.maxMemory);
    limit(process, RLIMIT_CORE, 0);
}

/// Both ends of a program's input. No pipe: when the program no longer reads one, writing to it
/// ends this process by a signal.
Pipe openInput(const ProgramCall& call) {
    std::array<int, 2> ends{};
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
        fail(call, "cannot be started", errno);
    }
    return {FileDescriptor(ends[0]), FileDescriptor(ends[1])};
}

}  // namespace

ProgramCall trustedCall(std::filesystem::path program, std::vector<std::string> arguments) {
    constexpr std::uint64_t kAny = std::numeric_limits<std::uint64_t>::max();
    ProgramCall call{.program = std::move(program),
                     .arguments = std::move(arguments),
                     .environment = {},
                     .folder = {},
                     .maxOutput = kAny,
                     .maxFile = kAny,
                     .maxMemory = kAny};
    for (char** entry = environ; *entry != nullptr; ++entry) {
        call.environment.emplace_back(*entry);
    }
    return call;
}

RunningProgram::RunningProgram(ProgramCall call) : call_(std::move(call)), look_(kLook) {
    const FileDescriptor nothing(open("/dev/null", O_RDWR | O_CLOEXEC));
    if (!nothing.isOpen()) {
        fail(call_, "cannot be started", errno);
    }
    Pipe input = call_.isFed ? openInput(call_) : Pipe{};
    Pipe output = openPipe(call_);
    Pipe failure = openPipe(call_);
    const auto source = [&](ProgramStream stream, int own) {
        return stream == ProgramStream::Read      ? output.writing.get()
               : stream == ProgramStream::Dropped ? nothing.get()
                                                  : own;
    };
    process_ = started(call_,
                       {call_.isFed ? input.reading.get() : nothing.get(),
                        source(call_.output, STDOUT_FILENO), source(call_.errors, STDERR_FILENO),
                        call_.hasReplies ? output.writing.get() : -1},
                       failure.writing.get());
    failure.writing = FileDescriptor(-1);
    if (const int error = failureOf(failure.reading); error != 0) {
        (void)end();
        fail(call_, "cannot be started", error);
    }
    bound(process_, call_);
    input_ = std::move(input.writing);
    output_ = std::move(output.reading);
}

RunningProgram::~RunningProgram() { (void)end(); }

std::optional<std::size_t> RunningProgram::feed(std::span<const std::uint8_t> input) {
    wait(POLLOUT);
    takeOutput();
    const ssize_t count =
        send(input_.get(), input.data(), input.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (count >= 0) {
        return static_cast<std::size_t>(count);
    }
    return errno == EAGAIN || errno == EINTR ? std::optional<std::size_t>(0) : std::nullopt;
}

void RunningProgram::endInput() { input_ = FileDescriptor(-1); }

std::optional<ProgramOutcome> RunningProgram::look() {
    if (Clock::now() >= call_.deadline) {
        return outcome(ProgramEnd::TimedOut);
    }
    wait(0);
    const bool ended = hasEnded();
    takeOutput();
    if (text_.size() > call_.maxOutput) {
        return outcome(ProgramEnd::WroteTooMuch);
    }
    return ended ? std::optional(outcome(ProgramEnd::Exited)) : std::nullopt;
}

/// Until something comes, the input has room or it is time for a look.
/// @param inputEvent POLLOUT, or 0: the input does not matter
void RunningProgram::wait(short inputEvent) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(call_.deadline - Clock::now());
    const auto time = std::clamp(left, std::chrono::milliseconds{0}, look_);
    std::array<pollfd, 2> waited{
        pollfd{.fd = output_.get(), .events = POLLIN, .revents = 0},
        pollfd{.fd = inputEvent == 0 ? -1 : input_.get(), .events = inputEvent, .revents = 0}};
    (void)poll(waited.data(), waited.size(), static_cast<int>(time.count()));
    look_ = std::min(2 * look_, kLook);
}

/// Moves what the program has written until now.
void RunningProgram::takeOutput() {
    std::array<char, 16384> block{};
    while (output_.isOpen() && text_.size() <= call_.maxOutput) {
        const ssize_t count = read(output_.get(), block.data(), block.size());
        if (count > 0) {
            text_.append(block.data(), static_cast<std::size_t>(count));
        } else if (count < 0 && errno == EAGAIN) {
            return;
        } else if (count == 0 || errno != EINTR) {
            output_ = FileDescriptor(-1);
            look_ = kShortLook;
        }
    }
}

/// Returns whether the program has ended by itself. It stays a zombie, so that its number is its
/// own.
bool RunningProgram::hasEnded() {
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

ProgramOutcome RunningProgram::outcome(ProgramEnd reason) {
    const int status = end();
    ProgramOutcome outcome{.end = reason, .output = std::move(text_)};
    if (reason == ProgramEnd::Exited) {
        outcome.end = WIFEXITED(status)             ? ProgramEnd::Exited
                      : WTERMSIG(status) == SIGXCPU ? ProgramEnd::TimedOut
                                                    : ProgramEnd::Killed;
        outcome.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
    }
    return outcome;
}

/// Ends the program and what is left of its group. @return its wait status
int RunningProgram::end() noexcept {
    int status = 0;
    if (process_ > 0) {
        if (call_.endSignal != SIGKILL) {
            kill(process_, call_.endSignal);
            siginfo_t ended{};
            while (waitid(P_PID, static_cast<id_t>(process_), &ended, WEXITED | WNOWAIT) < 0 &&
                   errno == EINTR) {
            }
        }
        kill(-process_, SIGKILL);
        while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
        }
        process_ = -1;
    }
    return status;
}

ProgramOutcome runProgram(const ProgramCall& call) {
    RunningProgram program(call);
    std::optional<ProgramOutcome> outcome;
    while (!outcome) {
        outcome = program.look();
    }
    return *outcome;
}

bool isProgram(const std::filesystem::path& path) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(path, ignored) && access(path.c_str(), X_OK) == 0;
}

std::filesystem::path findProgram(const std::string& name, std::string_view folders) {
    while (!folders.empty()) {
        const std::string_view folder = folders.substr(0, folders.find(':'));
        std::filesystem::path program = std::filesystem::path(folder) / name;
        if (program.is_absolute() && isProgram(program)) {
            return program;
        }
        folders.remove_prefix(std::min(folder.size() + 1, folders.size()));
    }
    return {};
}

std::filesystem::path findProgram(const std::string& name) {
    const char* const folders = std::getenv("PATH");  // NOLINT(concurrency-mt-unsafe)
    return findProgram(name, folders != nullptr ? folders : "/usr/bin:/bin");
}

}  // namespace asperity
