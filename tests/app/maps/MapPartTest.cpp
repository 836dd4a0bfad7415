#include "app/maps/MapPart.h"

#include "core/Error.h"
#include "tests/support/ScratchFolder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

namespace asperity {
namespace {

const MapPlan kPlan{.grid = {.columns = 3, .rows = 4},
                    .region = {0.0, 0.0, 3e-9, 4e-9},
                    .setpoint = 1e-9,
                    .quantities = {MapQuantity::Height, MapQuantity::Stiffness}};
const std::vector<double> kRow{1.0, 2.0, 3.0, 4.0, 5.0, 6.0};

std::vector<double> readOf(const MapPart& part, int row, std::size_t quantity) {
    std::vector<double> values(3);
    part.read(row, quantity, values.data());
    return values;
}

TEST(MapPart, HoldsRowsInAnyOrder) {
    const test::ScratchFolder scratch;
    MapPart part(scratch.file("part"), kPlan, "key", PartUse::New);
    part.keep(2, kRow);
    part.keep(0, {6.0, 5.0, 4.0, 3.0, 2.0, 1.0});
    EXPECT_EQ(part.count(), 2);
    EXPECT_EQ(readOf(part, 2, 0), (std::vector{1.0, 2.0, 3.0}));
    EXPECT_EQ(readOf(part, 2, 1), (std::vector{4.0, 5.0, 6.0}));
    EXPECT_EQ(readOf(part, 0, 1), (std::vector{3.0, 2.0, 1.0}));
    EXPECT_TRUE(std::isnan(readOf(part, 1, 0)[0]));
}

/// Wherever a record was cut, the rows before it are kept and the rest is written again.
TEST(MapPart, GoesOnAfterTheLastWholeRow) {
    const test::ScratchFolder scratch;
    {
        MapPart part(scratch.file("part"), kPlan, "key", PartUse::New);
        part.keep(1, kRow);
        part.keep(3, kRow);
    }
    const std::string whole = test::contentOf(scratch.file("part"));
    for (std::size_t length = 0; length < whole.size(); ++length) {
        const auto cut = scratch.write("cut", whole.substr(0, length));
        MapPart part(cut, kPlan, "key", PartUse::Resume);
        EXPECT_FALSE(part.has(3));
        if (!part.has(1)) {
            part.keep(1, kRow);
        }
        part.keep(3, kRow);
        ASSERT_EQ(test::contentOf(cut), whole) << length;
    }
}

TEST(MapPart, DropsARowThatIsDamagedAndNoOther) {
    const test::ScratchFolder scratch;
    {
        MapPart part(scratch.file("part"), kPlan, "key", PartUse::New);
        part.keep(1, kRow);
        part.keep(3, kRow);
    }
    const std::string whole = test::contentOf(scratch.file("part"));
    const std::size_t record = (whole.size() - whole.find('\n') - 1) / 2;
    const auto damagedAt = [&](std::size_t offset, const char* name) {
        std::string bytes = whole;
        bytes[offset] = static_cast<char>(bytes[offset] ^ 1);
        return MapPart(scratch.write(name, bytes), kPlan, "key", PartUse::Resume);
    };
    const MapPart last = damagedAt(whole.size() - 1, "last");
    EXPECT_TRUE(last.has(1) && !last.has(3));
    const MapPart first = damagedAt(whole.size() - record - 1, "first");
    EXPECT_TRUE(!first.has(1) && first.has(3));
}

TEST(MapPart, LeavesAFileThatIsNone) {
    const test::ScratchFolder scratch;
    const auto notes = scratch.write("part", "my notes");
    EXPECT_THROW(MapPart(notes, kPlan, "key", PartUse::Resume), Error);
    EXPECT_EQ(test::contentOf(notes), "my notes");
}

TEST(MapPart, OfAnotherMapIsRefused) {
    const test::ScratchFolder scratch;
    MapPart(scratch.file("part"), kPlan, "key", PartUse::New).keep(1, kRow);
    EXPECT_THROW(MapPart(scratch.file("part"), kPlan, "yek", PartUse::Resume), Error);
    EXPECT_THROW(MapPart(scratch.file("part"), kPlan, "key", PartUse::New), Error);
    EXPECT_EQ(MapPart(scratch.file("part"), kPlan, "yek", PartUse::Replace).count(), 0);
}

TEST(MapPart, IsWrittenByOneProcess) {
    const test::ScratchFolder scratch;
    const MapPart part(scratch.file("part"), kPlan, "key", PartUse::New);
    EXPECT_THROW(MapPart(scratch.file("part"), kPlan, "key", PartUse::Resume), Error);
    EXPECT_THROW(MapPart(scratch.file("part"), kPlan, "key", PartUse::Replace), Error);
    EXPECT_TRUE(std::filesystem::exists(scratch.file("part")));
}

}  // namespace
}  // namespace asperity
