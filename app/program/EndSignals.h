#pragma once

#include <csignal>

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
    struct sigaction interrupt_ {};  ///< what was there before
    struct sigaction terminate_ {};
    struct sigaction hangUp_ {};
};

}  // namespace asperity
