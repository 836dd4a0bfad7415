#include "core/surface/closest/KnownParts.h"

#include "core/Units.h"

#include <gtest/gtest.h>

#include <vector>

namespace asperity {

namespace {

constexpr CellIndex kFirst{.row = 10, .column = 20};

CellSet cellsOf(const std::vector<CellIndex>& cells) {
    CellSet set(kFirst);
    for (const CellIndex& cell : cells) {
        set.add(cell);
    }
    return set;
}

/// A part that lies 5 nm above the query and more, holds a minimum, and none for 1 nm around.
PartFacts factsAbove() {
    PartFacts facts;
    facts.way = {Double4{}, Double4{}, Double4{} + 2.0};
    facts.alongWay = Double4{} + 2.0 * 5.0_nm;
    facts.least = Double4{} + 0.5 * 4.0_nm * 4.0_nm;
    facts.calm = Double4{} + 1.0_nm;
    facts.convexFor = Double4{} + 0.5_nm;
    facts.withoutMinimum = PartBatch::kAllLanes;
    facts.convex = PartBatch::kAllLanes;
    return facts;
}

bool isDue(const KnownParts& parts, const Vector3& query, double distance) {
    return !parts.due(query, distance).empty();
}

class OnePart : public testing::Test {
protected:
    KnownParts parts_;
    Vector3 query_{10.0_nm, 20.0_nm, 30.0_nm};

    void SetUp() override {
        // The planes are kept from another origin than the query.
        ASSERT_TRUE(parts_.keepCells(cellsOf({kFirst}), Vector3(1.0_um, 0.0, -1.0_um)));
    }
    void note(const PartFacts& facts) { parts_.note(0, query_, facts, 2); }
};

TEST_F(OnePart, IsLookedAtFirst) { EXPECT_TRUE(isDue(parts_, query_, 0.0)); }

TEST_F(OnePart, IsQuietAsLongAsItsPlaneIsFar) {
    PartFacts facts = factsAbove();
    facts.far = PartBatch::kAllLanes;
    note(facts);
    EXPECT_FALSE(isDue(parts_, query_, 4.999_nm));
    EXPECT_TRUE(isDue(parts_, query_, 5.001_nm));
    const Vector3 up(0.0, 0.0, 2.0_nm);
    EXPECT_FALSE(isDue(parts_, query_ + up, 2.999_nm));
    EXPECT_TRUE(isDue(parts_, query_ + up, 3.001_nm));
    // The plane stands across z: along x the query may move at will.
    EXPECT_FALSE(isDue(parts_, query_ + Vector3(1.0_um, 0.0, 0.0), 4.999_nm));
}

TEST_F(OnePart, IsQuietAsLongAsItIsFar) {
    PartFacts facts = factsAbove();
    facts.far = PartBatch::kAllLanes;
    facts.alongWay = Double4{};
    note(facts);
    const Vector3 aside(0.6_nm, 0.0, 0.8_nm);
    EXPECT_FALSE(isDue(parts_, query_ + aside, 2.999_nm));
    EXPECT_TRUE(isDue(parts_, query_ + aside, 3.001_nm));
}

TEST_F(OnePart, IsQuietAsLongAsItIsCalm) {
    note(factsAbove());
    EXPECT_FALSE(isDue(parts_, query_ + Vector3(0.0, 0.0, 0.999_nm), 1.0_um));
    EXPECT_TRUE(isDue(parts_, query_ + Vector3(0.0, 0.0, 1.001_nm), 1.0_um));
}

TEST_F(OnePart, IsNotCalmWhereItHoldsAMinimum) {
    PartFacts facts = factsAbove();
    facts.withoutMinimum = 0b1011U;
    note(facts);
    EXPECT_TRUE(isDue(parts_, query_, 1.0_um));
}

TEST_F(OnePart, HasOneMinimumAtMostNearby) {
    note(factsAbove());
    EXPECT_TRUE(parts_.isConvex(0, query_ + Vector3(0.499_nm, 0.0, 0.0)));
    EXPECT_FALSE(parts_.isConvex(0, query_ + Vector3(0.501_nm, 0.0, 0.0)));
    PartFacts facts = factsAbove();
    facts.convex = 0b1011U;
    note(facts);
    EXPECT_FALSE(parts_.isConvex(0, query_));
}

TEST_F(OnePart, HasQuartersOfWhichNothingIsKnown) {
    note(factsAbove());
    const auto quarters = parts_.split(0);
    ASSERT_TRUE(quarters);
    EXPECT_EQ(*quarters, (KnownParts::Quarters{0, 1, 2, 3}));
    EXPECT_EQ(parts_.due(query_, 0.1_nm).size(), 4U);
    EXPECT_EQ(parts_.at(3).depth, 1);
    EXPECT_EQ(parts_.at(3).row, 1);
    EXPECT_EQ(parts_.at(2).column, 0);
    parts_.note(3, query_, factsAbove(), 0);
    EXPECT_EQ(parts_.due(query_, 0.1_nm).size(), 3U);
}

TEST_F(OnePart, IsQuarteredSoManyTimes) {
    std::size_t splits = 0;
    while (parts_.split(0)) {
        ++splits;
    }
    EXPECT_EQ(splits, static_cast<std::size_t>(CellPart::kMaxDepth));
}

TEST(KnownParts, AreQuarteredWhileThereIsRoom) {
    CellSet cells(kFirst);
    for (int i = 0; i < CellSet::kSide; ++i) {
        cells.add({.row = kFirst.row + i, .column = kFirst.column});
    }
    KnownParts parts;
    ASSERT_TRUE(parts.keepCells(cells, Vector3::Zero()));
    std::size_t part = 0;
    while (part < parts.size() && (parts.at(part).depth > 2 || parts.split(part))) {
        part += parts.at(part).depth > 2 ? 1 : 0;
    }
    EXPECT_GT(parts.size() + KnownParts::kGroup - 1, KnownParts::kMaxParts);
    EXPECT_LE(parts.size(), KnownParts::kMaxParts);
}

/// Where there are many parts, an eighth of the divided cells is forgotten at a time.
TEST(KnownParts, AreStartedAnewWhereTheyAreMany) {
    CellSet cells(kFirst);
    for (int i = 0; i < 8 * CellSet::kSide; ++i) {
        cells.add(
            {.row = kFirst.row + i % CellSet::kSide, .column = kFirst.column + i / CellSet::kSide});
    }
    KnownParts parts;
    ASSERT_TRUE(parts.keepCells(cells, Vector3::Zero()));
    while (parts.size() + KnownParts::kGroup <= KnownParts::kMaxParts) {
        std::size_t whole = 0;
        while (parts.at(whole).depth > 0) {
            ++whole;
        }
        ASSERT_TRUE(parts.split(whole));
    }
    for (int turn = 0; turn < 8; ++turn) {
        const std::size_t before = parts.size();
        ASSERT_TRUE(parts.keepCells(cells, Vector3::Zero()));
        EXPECT_LE(parts.size(), before);
        EXPECT_GE(parts.size(), before - before / 4);
    }
    EXPECT_LE(parts.size(), KnownParts::kMaxParts / 2 + KnownParts::kMaxParts / 8);
}

TEST(KnownParts, KeepWhatIsKnownOfCellsThatStay) {
    const CellIndex gone{.row = 11, .column = 20};
    const CellIndex stays{.row = 11, .column = 21};
    const CellIndex comes{.row = 12, .column = 22};
    const Vector3 query(1.0_nm, 2.0_nm, 3.0_nm);
    KnownParts parts;
    ASSERT_TRUE(parts.keepCells(cellsOf({gone, stays}), query));
    for (std::size_t i = 0; i < parts.size(); ++i) {
        parts.note(i, query, factsAbove(), 0);
    }
    ASSERT_TRUE(parts.split(0));
    ASSERT_TRUE(parts.keepCells(cellsOf({stays, comes}), query));
    ASSERT_EQ(parts.size(), 2U);
    EXPECT_EQ(parts.at(0).cell.column, stays.column);
    EXPECT_EQ(parts.at(1).cell.column, comes.column);
    const auto due = parts.due(query, 0.5_nm);
    ASSERT_EQ(due.size(), 1U);
    EXPECT_EQ(due.front(), 1);
}

TEST(KnownParts, SayWhereTheyHaveNoRoom) {
    CellSet cells(kFirst);
    for (int i = 0; i < static_cast<int>(KnownParts::kMaxParts) + 1; ++i) {
        cells.add(
            {.row = kFirst.row + i / CellSet::kSide, .column = kFirst.column + i % CellSet::kSide});
    }
    KnownParts parts;
    EXPECT_FALSE(parts.keepCells(cells, Vector3::Zero()));
}

}  // namespace
}  // namespace asperity
