#include "app/window/live/ViewMemory.h"

#include "app/window/live/LivePanels.h"
#include "ui/shell/MainWindow.h"
#include "ui/shell/Menus.h"
#include "ui/view/ColorsMenu.h"
#include "ui/view/SecondView.h"
#include "ui/view/ZoomView.h"

#include <QAction>
#include <QVariantMap>

#include <gtest/gtest.h>

namespace asperity::test {
namespace {

TEST(ViewMemory, KeepsHowTheViewsLook) {
    QVariantMap kept;
    SurfaceLook look;
    look.quantity = SurfaceQuantity::Slope;
    look.of(SurfaceQuantity::Height) = {.map = ColorMap::Gold,
                                        .rule = RangeRule::Own,
                                        .low = -2e-9,
                                        .high = 5.5e-9,
                                        .pinned = true};
    const ViewOptions options{.heightScale = 3.5, .grid = true, .trueTip = true};
    const SecondViewSettings second{.content = SecondContent::Space,
                                    .options = {.axes = false},
                                    .followsContact = false,
                                    .azimuth = 30.0};
    {
        MainWindow window;
        LivePanels panels{window};
        panels.colors().choose(look);
        panels.view().setOptions(options);
        panels.view().setPerspective(true);
        panels.second().setSettings(second);
        window.menus().entry("secondView").setChecked(false);
        keepViews(panels, kept);
        keepViewpoint(panels, kept);
    }
    MainWindow window;
    LivePanels panels{window};
    restoreViews(panels, kept);
    SurfaceLook unpinned = look;
    unpinned.of(SurfaceQuantity::Height).pinned = false;  // it was of a scan
    EXPECT_EQ(panels.colors().look(), unpinned);
    restoreViewpoint(panels, kept);
    EXPECT_EQ(panels.colors().look(), look) << "of the same scan";
    EXPECT_EQ(panels.view().options(), options);
    EXPECT_TRUE(panels.view().camera().hasPerspective());
    EXPECT_EQ(panels.second().settings().content, SecondContent::Space);
    EXPECT_EQ(panels.second().settings().options, second.options);
    EXPECT_EQ(panels.second().settings().azimuth, 30.0);
    EXPECT_FALSE(panels.second().settings().followsContact);
    EXPECT_FALSE(window.menus().entry("secondView").isChecked());
}

TEST(ViewMemory, WhatCannotBeReadIsAsAtFirst) {
    const QVariantMap kept{
        {"views/colorBy", "taste"},           {"views/colors/height/map", "plaid"},
        {"views/colors/height/range", "own"}, {"views/colors/height/low", "9"},
        {"views/colors/height/high", "1"},    {"views/large/heightScale", "-3"},
        {"stand/azimuth_rad", "north"},       {"stand/pinned", 3}};
    MainWindow window;
    LivePanels panels{window};
    restoreViews(panels, kept);
    restoreViewpoint(panels, kept);
    SurfaceLook first;
    first.of(SurfaceQuantity::Height).low = 9.0;
    EXPECT_EQ(panels.colors().look(), first) << "an own range upside down is none";
    EXPECT_EQ(panels.view().options(), ViewOptions());
    EXPECT_TRUE(window.menus().entry("secondView").isChecked());
}

}  // namespace
}  // namespace asperity::test
