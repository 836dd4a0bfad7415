#pragma once

#include "app/window/live/LivePanels.h"
#include "tests/support/Waits.h"
#include "ui/view/ZoomView.h"

#include <gtest/gtest.h>

namespace asperity::test {

/// Waits until a window is laid out and its surface is drawn for good.
inline void settle(LivePanels& panels) {
    handleEvents();
    ASSERT_TRUE(eventually([&panels] { return panels.view().isSettled(); }));
}

}  // namespace asperity::test
