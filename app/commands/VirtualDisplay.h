#pragma once

#include "app/program/DataFolder.h"
#include "core/ProgramRun.h"

#include <memory>
#include <optional>
#include <string>

class QGuiApplication;

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

/// Qt application that can draw letters without a display: the only one while this object lives.
class OffscreenApplication {
public:
    OffscreenApplication();
    ~OffscreenApplication();
    OffscreenApplication(const OffscreenApplication&) = delete;
    OffscreenApplication& operator=(const OffscreenApplication&) = delete;

private:
    RuntimeFolder runtime_;
    int argumentCount_;
    char* arguments_[4];
    std::unique_ptr<QGuiApplication> application_;
};

}  // namespace asperity
