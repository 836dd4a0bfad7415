#pragma once

#include <csignal>
#include <exception>
#include <string>

namespace asperity {

/// While one lives, a handler of its own answers SIGINT, SIGTERM and SIGHUP (the terminal was
/// closed); then what was there before is put back. A signal that the program was started to ignore
/// (nohup, a shell's background job) stays ignored. They may be nested.
class EndSignals {
public:
    /// @param handler may do only what a signal handler may
    explicit EndSignals(void (*handler)(int));
    ~EndSignals();
    EndSignals(const EndSignals&) = delete;
    EndSignals& operator=(const EndSignals&) = delete;

private:
    struct sigaction interrupt_ {};  ///< the former action
    struct sigaction terminate_ {};
    struct sigaction hangUp_ {};
};

/// While one lives, SIGINT, SIGTERM and SIGHUP are noted in place of ending the program, so that
/// long work can end in good order. What was noted stays so: the program is about to end. They may
/// be nested.
class CancelOnSignal {
public:
    CancelOnSignal();

    [[nodiscard]] static bool hasArrived();

private:
    EndSignals signals_;
};

// The exit codes are part of the command line's contract.
inline constexpr int kFailed = 1;
inline constexpr int kWrongUsage = 2;
inline constexpr int kFileError = 3;

/// Returns what an error says as one line to print; what it quotes of a file can be of any length
/// and is cut.
[[nodiscard]] std::string messageOf(const std::exception& error);

/// Prints on standard error in one sentence what failed. @return the exit code
[[nodiscard]] int reportError(const std::exception_ptr& error);

/// Opens what the program was started without of standard input, output and error (`<&- >&- 2>&-`),
/// so that no file or pipe opened later takes such a number and is read or written by mistake. To
/// read or write them is an error still: nothing that a user asked for is lost unnoticed. Called
/// before anything else opens a file.
void openClosedStandardStreams();

}  // namespace asperity
