#include "ui/window/ViewMemory.h"

#include "ui/view/ZoomView.h"
#include "ui/window/ColorsMenu.h"
#include "ui/window/MainWindow.h"
#include "ui/window/SecondView.h"
#include "ui/window/WindowMenus.h"

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
    const ViewOptions options{.heightScale = 3.5, .grid = false, .trueTip = true};
    const SecondViewSettings second{
        .content = SecondContent::Space, .options = {.axes = false}, .azimuth = 30.0};
    {
        MainWindow window;
        window.menus().colors().choose(look);
        window.view().setOptions(options);
        window.view().setPerspective(true);
        window.second().setSettings(second);
        window.menus().secondView->setChecked(true);
        keepViews(window, kept);
        keepStand(window, kept);
    }
    MainWindow window;
    restoreViews(window, kept);
    SurfaceLook unpinned = look;
    unpinned.of(SurfaceQuantity::Height).pinned = false;  // it was of a scan
    EXPECT_EQ(window.menus().colors().look(), unpinned);
    restoreStand(window, kept);
    EXPECT_EQ(window.menus().colors().look(), look) << "of the same scan";
    EXPECT_EQ(window.view().options(), options);
    EXPECT_TRUE(window.view().camera().hasPerspective());
    EXPECT_EQ(window.second().settings().content, SecondContent::Space);
    EXPECT_EQ(window.second().settings().options, second.options);
    EXPECT_EQ(window.second().settings().azimuth, 30.0);
    EXPECT_TRUE(window.menus().secondView->isChecked());
}

TEST(ViewMemory, WhatCannotBeReadIsAsAtFirst) {
    const QVariantMap kept{
        {"views/colorBy", "taste"},           {"views/colors/height/map", "plaid"},
        {"views/colors/height/range", "own"}, {"views/colors/height/low", "9"},
        {"views/colors/height/high", "1"},    {"views/large/heightScale", "-3"},
        {"stand/azimuth_rad", "north"},       {"stand/pinned", 3}};
    MainWindow window;
    restoreViews(window, kept);
    restoreStand(window, kept);
    SurfaceLook first;
    first.of(SurfaceQuantity::Height).low = 9.0;
    EXPECT_EQ(window.menus().colors().look(), first) << "an own range upside down is none";
    EXPECT_EQ(window.view().options(), ViewOptions());
    EXPECT_FALSE(window.menus().secondView->isChecked());
}

}  // namespace
}  // namespace asperity::test
