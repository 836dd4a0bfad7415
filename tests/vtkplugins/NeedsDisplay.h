#pragma once

#include "vtkplugins/pictures/Display.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

/// Skips the calling test where no X display answers; with CI=true that is a failure.
#define ASPERITY_NEEDS_DISPLAY()                                                                   \
    if (!asperity::haveDisplay()) {                                                                \
        const char* ci = std::getenv("CI"); /* NOLINT(concurrency-mt-unsafe): tests are alone */   \
        if (ci != nullptr && std::string(ci) == "true") {                                          \
            FAIL() << "CI=true, but no X display answers";                                         \
        }                                                                                          \
        GTEST_SKIP() << "no X display answers (run under xvfb-run)";                               \
    }                                                                                              \
    static_assert(true)
