#include "ui/window/ViewMemory.h"

#include "tests/support/ScratchFolder.h"
#include "ui/view/ZoomView.h"
#include "ui/window/ColorsMenu.h"
#include "ui/window/MainWindow.h"
#include "ui/window/SecondView.h"
#include "ui/window/WindowMenus.h"

#include <QAction>
#include <QSettings>

#include <gtest/gtest.h>

namespace asperity::test {
namespace {

TEST(ViewMemory, KeepsHowTheViewsLook) {
    ScratchFolder folder;
    QSettings settings(QString::fromStdString(folder.file("a.ini").string()), QSettings::IniFormat);
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
        saveViews(window, settings);
    }
    MainWindow window;
    restoreViews(window, settings);
    look.of(SurfaceQuantity::Height).pinned = false;  // it was of a scan
    EXPECT_EQ(window.menus().colors().look(), look);
    EXPECT_EQ(window.view().options(), options);
    EXPECT_TRUE(window.view().camera().hasPerspective());
    EXPECT_EQ(window.second().settings().content, SecondContent::Space);
    EXPECT_EQ(window.second().settings().options, second.options);
    EXPECT_EQ(window.second().settings().azimuth, 30.0);
    EXPECT_TRUE(window.menus().secondView->isChecked());
}

TEST(ViewMemory, WhatCannotBeReadIsAsAtFirst) {
    ScratchFolder folder;
    (void)folder.write("a.ini", "[views]\ncolorBy=taste\ncolors\\height\\map=plaid\n"
                                "colors\\height\\range=own\ncolors\\height\\low=9\n"
                                "colors\\height\\high=1\nlarge\\heightScale=-3\n");
    QSettings settings(QString::fromStdString(folder.file("a.ini").string()), QSettings::IniFormat);
    MainWindow window;
    restoreViews(window, settings);
    SurfaceLook first;
    first.of(SurfaceQuantity::Height).low = 9.0;
    EXPECT_EQ(window.menus().colors().look(), first) << "an own range upside down is none";
    EXPECT_EQ(window.view().options(), ViewOptions());
    EXPECT_FALSE(window.menus().secondView->isChecked());
}

}  // namespace
}  // namespace asperity::test
