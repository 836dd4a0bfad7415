#pragma once

#include "tests/support/Waits.h"
#include "ui/view/ZoomView.h"
#include "ui/window/MainWindow.h"

#include <gtest/gtest.h>

namespace asperity::test {

/// Waits until a window is laid out and its surface is drawn for good.
inline void settle(MainWindow& window) {
    handleEvents();
    ASSERT_TRUE(eventually([&window] { return window.view().isSettled(); }));
}

}  // namespace asperity::test
