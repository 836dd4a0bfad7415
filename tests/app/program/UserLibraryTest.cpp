#include "app/program/DataFolder.h"
#include "core/Error.h"
#include "tests/support/ScratchFolder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace asperity::test {
namespace {

class UserLibraryTest : public ::testing::Test {
protected:
    UserLibraryTest() { library.setFolder(scratch.path() / "own"); }
    [[nodiscard]] long owned() const {
        return std::ranges::count(library.entries(), true, &UserLibrary::Entry::own);
    }

    ScratchFolder scratch;
    UserLibrary library{"materials"};
};

TEST_F(UserLibraryTest, ListsThoseOfTheProgramThenTheUsersOwn) {
    const std::size_t shipped = library.entries().size();
    EXPECT_GE(shipped, 4U);
    EXPECT_EQ(owned(), 0);
    const std::filesystem::path file = library.save("My oxide / 2", "text");
    EXPECT_EQ(file.filename(), "my_oxide___2.toml");
    EXPECT_EQ(contentOf(file), "text");
    const std::vector<UserLibrary::Entry> entries = library.entries();
    ASSERT_EQ(entries.size(), shipped + 1);
    EXPECT_TRUE(entries.back().own);
    EXPECT_EQ(entries.back().file, file);
}

TEST_F(UserLibraryTest, ThoseOfTheProgramStayAsTheyAre) {
    EXPECT_THROW(library.save("Polystyrene", "text"), Error);
    EXPECT_THROW(library.remove(library.entries().front()), Error);
    EXPECT_TRUE(std::filesystem::exists(library.entries().front().file));
}

TEST_F(UserLibraryTest, OwnOnesAreReplacedAndDeleted) {
    library.save("mine", "one");
    const std::filesystem::path file = library.save("mine", "two");
    EXPECT_EQ(contentOf(file), "two");
    EXPECT_EQ(owned(), 1);
    library.remove(library.entries().back());
    EXPECT_EQ(owned(), 0);
    EXPECT_FALSE(std::filesystem::exists(file));
}

TEST_F(UserLibraryTest, RefusesWhatIsNoNameOrHasNoFolder) {
    EXPECT_THROW(library.save("", "text"), Error);
    EXPECT_THROW(library.save(" /.. ", "text"), Error);
    library.setFolder({});
    EXPECT_THROW(library.save("mine", "text"), Error);
    library.setFolder(scratch.write("file", "no folder") / "own");
    EXPECT_THROW(library.save("mine", "text"), Error);
}

}  // namespace
}  // namespace asperity::test
