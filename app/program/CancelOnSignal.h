#pragma once

#include "app/program/EndSignals.h"

namespace asperity {

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

}  // namespace asperity
