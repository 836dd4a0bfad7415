#pragma once

namespace asperity {

/// While one lives, SIGINT and SIGTERM are noted in place of ending the program, so that long work
/// can end in good order. What was noted stays so: the program is about to end. One at a time.
class CancelOnSignal {
public:
    CancelOnSignal();
    ~CancelOnSignal();
    CancelOnSignal(const CancelOnSignal&) = delete;
    CancelOnSignal& operator=(const CancelOnSignal&) = delete;

    [[nodiscard]] static bool hasArrived();
};

}  // namespace asperity
