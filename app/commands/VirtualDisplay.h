#pragma once

#include "core/ProgramRun.h"

#include <optional>
#include <string>

namespace asperity {

/// A display to draw pictures on. Where one answers at DISPLAY it is used; else Xvfb is started for
/// as long as this object lives.
class VirtualDisplay {
public:
    /// @throw Error when there is no display and Xvfb cannot be started
    VirtualDisplay();
    ~VirtualDisplay();
    VirtualDisplay(const VirtualDisplay&) = delete;
    VirtualDisplay& operator=(const VirtualDisplay&) = delete;

private:
    std::string before_;  ///< DISPLAY
    std::optional<RunningProgram> server_;
};

}  // namespace asperity
