#pragma once

#include "app/program/RuntimeFolder.h"

#include <memory>

class QGuiApplication;

namespace asperity {

/// What Qt needs to draw letters, without a display: the only one, as long as this object lives.
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
