#include "app/window/scene/RecentFiles.h"

#include "tests/support/ScratchFolder.h"

#include <QtTest>

#include <gtest/gtest.h>

#include <string>

namespace asperity::test {
namespace {

class RecentFilesTest : public ::testing::Test {
protected:
    std::unique_ptr<QSettings> settings() {
        return std::make_unique<QSettings>(QString::fromStdString(folder.file("a.ini").string()),
                                           QSettings::IniFormat);
    }

    ScratchFolder folder;
};

TEST_F(RecentFilesTest, TheNewestComesFirstAndEachOnce) {
    RecentFiles recent;
    QSignalSpy changed(&recent, &RecentFiles::changed);
    recent.add("/scans/a.gwy");
    recent.add("/scans/b.gwy");
    recent.add("/scans/../scans/a.gwy");
    EXPECT_EQ(recent.files(), (std::vector<std::filesystem::path>{"/scans/a.gwy", "/scans/b.gwy"}));
    EXPECT_EQ(changed.count(), 3);
}

TEST_F(RecentFilesTest, AFolderCanBeLeftOut) {
    RecentFiles recent;
    recent.add("/data/session/session_before.toml");
    recent.add("/scans/a.gwy");
    recent.leaveOut("/data/session");
    recent.add("/data/session/session_last.toml");
    EXPECT_EQ(recent.files(), std::vector<std::filesystem::path>{"/scans/a.gwy"});
}

TEST_F(RecentFilesTest, TenAreKept) {
    RecentFiles recent;
    for (int i = 0; i < 15; ++i) {
        recent.add("/scans/" + std::to_string(i) + ".gwy");
    }
    ASSERT_EQ(recent.files().size(), 10U);
    EXPECT_EQ(recent.files().front(), "/scans/14.gwy");
    EXPECT_EQ(recent.files().back(), "/scans/5.gwy");
}

TEST_F(RecentFilesTest, StayFromOneSessionToTheNext) {
    {
        RecentFiles recent;
        recent.remember(settings());
        recent.add("/scans/a.gwy");
        recent.add("/scans/25\xB5m.gsf");  // no UTF-8
        recent.setFolder("/scans/today");
    }
    RecentFiles next;
    QSignalSpy changed(&next, &RecentFiles::changed);
    next.remember(settings());
    EXPECT_EQ(next.files(),
              (std::vector<std::filesystem::path>{"/scans/25\xB5m.gsf", "/scans/a.gwy"}));
    EXPECT_EQ(next.folder(), "/scans/today");
    EXPECT_EQ(changed.count(), 1);
    next.clear();
    RecentFiles last;
    last.remember(settings());
    EXPECT_TRUE(last.files().empty());
    EXPECT_EQ(last.folder(), "/scans/today");
}

TEST_F(RecentFilesTest, NonsenseInTheSettingsIsLeftOut) {
    (void)folder.write("a.ini", "[open]\nrecentFiles=file:///%ZZ, /scans/a.gwy\n");
    RecentFiles recent;
    recent.remember(settings());
    EXPECT_EQ(recent.files(), std::vector<std::filesystem::path>{"/scans/a.gwy"});
}

}  // namespace
}  // namespace asperity::test
