#pragma once

#include "core/GrowingFile.h"

#include <chrono>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <sys/types.h>
#include <vector>

namespace asperity {

/// Destination of a program's standard output or errors.
enum class ProgramStream : std::uint8_t {
    Read,  ///< into ProgramOutcome::output
    Dropped,
    Shared  ///< it writes where this process does
};

/// A program to run and the bounds that it is kept in.
struct ProgramCall {
    std::filesystem::path program;
    std::vector<std::string> arguments;    ///< behind the program's name
    std::vector<std::string> environment;  ///< NAME=VALUE; it gets no other
    std::filesystem::path folder;  ///< the one that it starts in; empty: that of this process
    bool isFed = false;            ///< by RunningProgram::feed(); else it has no input
    ProgramStream output = ProgramStream::Read;
    ProgramStream errors = ProgramStream::Read;
    bool hasReplies = false;  ///< its descriptor 3 is open, and what it writes there is read, too
    int endSignal = SIGKILL;  ///< that ends it when this process no longer needs it, or has ended
    std::chrono::steady_clock::time_point deadline = std::chrono::steady_clock::time_point::max();
    /// It and each that it starts may compute for: unlike the deadline it does not depend on what
    /// else the machine does.
    std::chrono::seconds maxProcessorTime = std::chrono::seconds::max();
    std::uint64_t maxOutput = std::uint64_t{1} << 20U;  ///< that is read [bytes]
    std::uint64_t maxFile = std::uint64_t{1} << 31U;    ///< each that it writes [bytes]
    std::uint64_t maxMemory = std::uint64_t{1} << 33U;  ///< its address space [bytes]
};

/// Returns a call of a program that gets data of this one alone: in this process's environment and
/// folder, for as long and with as much memory as it wants.
[[nodiscard]] ProgramCall trustedCall(std::filesystem::path program,
                                      std::vector<std::string> arguments);

enum class ProgramEnd : std::uint8_t {
    Exited,
    Killed,    ///< by a signal, as when it crashed or wrote too large a file
    TimedOut,  ///< at its deadline, or with its processor time used up
    WroteTooMuch
};

struct ProgramOutcome {
    ProgramEnd end = ProgramEnd::Exited;
    int exitCode = 0;    ///< of one that exited
    std::string output;  ///< read so far, unchanged
};

/// A program that was started without a shell, in a process group of its own. No process of the
/// group outlives this object; where this process is killed before, the program ends with it, but
/// not what the program has started itself. It inherits no open file but the streams of its call;
/// its signals are as at the start of a program. The thread that starts it must outlive this
/// object: with the thread the program would end.
class RunningProgram {
public:
    /// @throw Error when it cannot be started
    explicit RunningProgram(ProgramCall call);
    ~RunningProgram();
    RunningProgram(const RunningProgram&) = delete;
    RunningProgram& operator=(const RunningProgram&) = delete;

    /// Gives the program more input; waits up to 20 ms until it takes any.
    /// @return how many bytes it took; empty: it reads no more, as one that has ended
    [[nodiscard]] std::optional<std::size_t> feed(std::span<const std::uint8_t> input);
    /// Ends its input: it has all of it.
    void endInput();

    /// Waits up to 20 ms for more output or its end.
    /// @return how it ended, by itself or at a bound of its call; then this is not called again
    /// @throw Error when it cannot be waited for
    [[nodiscard]] std::optional<ProgramOutcome> look();
    /// Returns the output that was read until now.
    [[nodiscard]] const std::string& output() const { return text_; }

private:
    void wait(short inputEvent);
    void takeOutput();
    [[nodiscard]] bool hasEnded();
    [[nodiscard]] ProgramOutcome outcome(ProgramEnd reason);
    int end() noexcept;

    ProgramCall call_;
    FileDescriptor input_{-1};
    FileDescriptor output_{-1};       ///< -1: nothing more comes
    std::chrono::milliseconds look_;  ///< wait for input
    std::string text_;
    pid_t process_ = -1;
};

/// Runs a program to its end. Any threads.
/// @throw Error when it cannot be started or waited for
[[nodiscard]] ProgramOutcome runProgram(const ProgramCall& call);

/// Returns whether a path leads to a file that this process may run.
[[nodiscard]] bool isProgram(const std::filesystem::path& path);
/// Returns the first program of this name in folders that a list names, as PATH does; empty: none.
/// A folder that is not absolute is left out: it would depend on the one that the user is in.
[[nodiscard]] std::filesystem::path findProgram(const std::string& name, std::string_view folders);
/// Returns the one in the folders of PATH.
[[nodiscard]] std::filesystem::path findProgram(const std::string& name);

}  // namespace asperity
