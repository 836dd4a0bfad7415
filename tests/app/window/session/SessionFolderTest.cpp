#include "app/window/WindowSection.h"
#include "app/window/session/SessionControl.h"
#include "tests/support/ScratchFolder.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>

namespace asperity::test {
namespace {

namespace fs = std::filesystem;

/// Programs that start one after the other.
class SessionFolderTest : public ::testing::Test {
protected:
    /// One that keeps a session until it ends.
    void run(const std::string& name, bool isEdited) {
        const SessionFolder folder(position);
        QVariantMap kept;
        keepEdited(isEdited, kept);
        (void)scratch.write("kept/session.toml", "# " + name + "\n" + windowSection(kept));
    }
    static std::string nameIn(const fs::path& file) {
        const std::string text = file.empty() ? "# none\n" : contentOf(file);
        return text.substr(2, text.find('\n') - 2);
    }
    void expect(const std::string& last, const std::string& before) {
        const SessionFolder folder(position);
        EXPECT_EQ(nameIn(folder.last()), last);
        EXPECT_EQ(nameIn(folder.before()), before);
    }

    ScratchFolder scratch;
    fs::path position = scratch.file("kept");
};

TEST_F(SessionFolderTest, HasNothingAtFirst) { expect("none", "none"); }

TEST_F(SessionFolderTest, OfTwoProgramsTheFirstHasIt) {
    const SessionFolder first(position);
    const SessionFolder second(position);
    EXPECT_TRUE(first.isOurs());
    EXPECT_FALSE(second.isOurs());
    EXPECT_TRUE(second.before().empty());
}

TEST_F(SessionFolderTest, WhatIsOnlyLookedAtReplacesNoEditedSession) {
    run("edited", true);
    run("a scan", false);
    run("another scan", false);
    expect("another scan", "edited");
    expect("another scan", "edited");  // a program that shows nothing changes nothing
    run("edited later", true);
    expect("edited later", "edited later");
}

TEST_F(SessionFolderTest, ASessionThatNotesNothingMayHaveBeenEdited) {
    (void)SessionFolder(position);
    (void)scratch.write("kept/session.toml", "# old\n[window]\n\"count\" = 3\n");
    expect("old", "old");
    run("a scan", false);
    expect("a scan", "old");
}

TEST_F(SessionFolderTest, WhatCannotBeOpenedStaysWhateverStartsThen) {
    run("on a disk that is away", true);
    fs::path aside;
    {
        SessionFolder folder(position);
        aside = folder.setLastAside();
        EXPECT_EQ(folder.before(), aside);
        EXPECT_TRUE(folder.last().empty());
    }
    run("shipped", false);
    expect("shipped", "on a disk that is away");
    run("edited", true);
    expect("edited", "edited");
    EXPECT_EQ(nameIn(aside), "on a disk that is away");
    SessionFolder folder(position);
    EXPECT_NE(folder.setLastAside(), aside);
    EXPECT_EQ(nameIn(aside), "on a disk that is away");
}

TEST_F(SessionFolderTest, ADamagedSessionReplacesNone) {
    run("edited", true);
    (void)SessionFolder(position);
    (void)scratch.write("kept/session.toml", "# damaged\n[[[");
    expect("damaged", "edited");
}

}  // namespace
}  // namespace asperity::test
