#include "core/Error.h"
#include "core/io/FileBytes.h"
#include "tests/support/ScratchFolder.h"

#include <gtest/gtest.h>

#include <array>

namespace asperity::test {

TEST(BufferedFile, GivesTheContentOfSmallAndLargeFilesAlike) {
    const ScratchFolder folder;
    for (const std::size_t size : {std::size_t{10}, (std::size_t{1} << 22U) + 10}) {
        const BufferedFile file(folder.write("scan", std::string(size - 3, 'x') + "end"));
        EXPECT_EQ(file.size(), size);
        std::array<char, 4> bytes{};
        file.read(size - 4, bytes);
        EXPECT_EQ(std::string(bytes.data(), bytes.size()), "xend");
        EXPECT_THROW(file.read(size - 3, bytes), InputError);
        EXPECT_THROW(file.read(size + 1, bytes), InputError);
    }
}

TEST(BufferedFile, SmallContentIsOfOneMomentAndItsChangeIsNoticed) {
    const ScratchFolder folder;
    const std::filesystem::path path = folder.write("scan", "before");
    const BufferedFile file(path);
    std::filesystem::resize_file(path, 2);
    EXPECT_EQ(file.start(6), "before");
    EXPECT_THROW(file.requireUnchanged(), InputError);
}

}  // namespace asperity::test
