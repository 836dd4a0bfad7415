#include "core/io/heightmap/SampleRows.h"

#include "core/Error.h"
#include "core/io/ByteReader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace asperity {
namespace {

constexpr ImageSize kImageSize{.columns = 3, .rows = 2};

std::vector<double> readRowOf(const ReadRow& rows, int row, RowRoom& room) {
    std::vector<double> numbers(kImageSize.columns);
    rows(row, room, numbers.data());
    return numbers;
}

std::vector<double> readRowOf(const ReadRow& rows, int row) {
    RowRoom room;
    return readRowOf(rows, row, room);
}

/// Six numbers after two bytes that are none of them.
template <typename Number>
std::string stored(ByteOrder order, const std::vector<double>& numbers) {
    std::string bytes = "ab";
    for (const double number : numbers) {
        std::string one;
        appendLittleEndian(one, static_cast<Number>(number));
        if (order == ByteOrder::Big) {
            std::ranges::reverse(one);
        }
        bytes += one;
    }
    return bytes;
}

template <typename Number>
void expectRead(SampleType type) {
    using Limits = std::numeric_limits<Number>;
    constexpr bool kIsExact = Limits::digits <= std::numeric_limits<double>::digits;
    const double most = std::ldexp(1.0, std::numeric_limits<double>::digits);
    const double low =
        kIsExact ? static_cast<double>(Limits::lowest()) : (Limits::is_signed ? -most : 0.0);
    const double high = kIsExact ? static_cast<double>(Limits::max()) : most;
    const std::vector<double> numbers{low, 0.0, 1.0, 2.0, 100.0, high};
    for (const ByteOrder order : {ByteOrder::Little, ByteOrder::Big}) {
        const std::string content = stored<Number>(order, numbers);
        const MemoryBytes bytes(content, "a file");
        SampleLayout layout{.size = kImageSize, .type = type, .order = order, .offset = 2};
        EXPECT_EQ(sizeOf(type), sizeof(Number));
        EXPECT_EQ(layout.bytes(), 6 * sizeof(Number));
        EXPECT_NO_THROW(requireSamples(bytes, layout, "image"));
        EXPECT_EQ(readRowOf(rowsOf(bytes, layout), 0), (std::vector<double>{low, 0.0, 1.0}));
        EXPECT_EQ(readRowOf(rowsOf(bytes, layout), 1), (std::vector<double>{2.0, 100.0, high}));
        layout.offset = 3;
        EXPECT_THROW(requireSamples(bytes, layout, "image"), InputError);
    }
}

TEST(SampleRows, ReadsEveryTypeInBothByteOrders) {
    expectRead<std::int8_t>(SampleType::Int8);
    expectRead<std::uint8_t>(SampleType::UInt8);
    expectRead<std::int16_t>(SampleType::Int16);
    expectRead<std::uint16_t>(SampleType::UInt16);
    expectRead<std::int32_t>(SampleType::Int32);
    expectRead<std::uint32_t>(SampleType::UInt32);
    expectRead<std::int64_t>(SampleType::Int64);
    expectRead<std::uint64_t>(SampleType::UInt64);
    expectRead<float>(SampleType::Float32);
    expectRead<double>(SampleType::Float64);
}

const std::string kBytes = "\1\2\3\4\5\6";
const SampleLayout kLayout{.size = kImageSize, .type = SampleType::Int8};

TEST(SampleRows, TurnsWhatIsStoredFromBelowOrFromTheRight) {
    const MemoryBytes bytes(kBytes, "a file");
    SampleLayout layout = kLayout;
    layout.bottomFirst = true;
    EXPECT_EQ(readRowOf(rowsOf(bytes, layout), 0), (std::vector<double>{4, 5, 6}));
    layout.rightFirst = true;
    EXPECT_EQ(readRowOf(rowsOf(bytes, layout), 0), (std::vector<double>{6, 5, 4}));
}

TEST(SampleRows, ADistantOffsetIsNoOverflow) {
    const MemoryBytes bytes(kBytes, "a file");
    SampleLayout layout = kLayout;
    layout.offset = std::numeric_limits<std::uint64_t>::max() - 2;
    EXPECT_THROW(requireSamples(bytes, layout, "image"), InputError);
}

TEST(SampleRows, DecodesOnceUnlessThatThrows) {
    int decoded = 0;
    const ReadRow rows = rowsOfDecoded(
        [&decoded] {
            if (++decoded == 1) {
                throw InputError("a file", "", "damaged");
            }
            return kBytes;
        },
        kLayout, "a file");
    EXPECT_EQ(decoded, 0);
    RowRoom room;
    EXPECT_THROW((void)readRowOf(rows, 0, room), InputError);
    EXPECT_EQ(readRowOf(rows, 1, room), (std::vector<double>{4, 5, 6}));
    EXPECT_EQ(readRowOf(rows, 0, room), (std::vector<double>{1, 2, 3}));
    RowRoom other;
    EXPECT_EQ(readRowOf(rows, 1, other), (std::vector<double>{4, 5, 6}));
    EXPECT_EQ(decoded, 2);
}

/// The images of a file, read one after the other, are not in memory together.
TEST(SampleRows, KeepsDecodedSamplesAsLongAsTheyAreRead) {
    int decoded = 0;
    const ReadRow rows = rowsOfDecoded(
        [&decoded] {
            ++decoded;
            return kBytes;
        },
        kLayout, "a file");
    for (int pass = 1; pass <= 3; ++pass) {
        RowRoom room;
        (void)readRowOf(rows, 0, room);
        (void)readRowOf(rows, 1, room);
        EXPECT_EQ(room.decoded.size(), 1U);
        EXPECT_EQ(decoded, pass);
    }
}

/// Images that are decoded together and read one after the other are decoded once.
TEST(SampleRows, KeepsTheLatestSamplesForTheNextImage) {
    int decoded = 0;
    const auto latest = std::make_shared<LatestSamples>();
    const auto decode = [&decoded] {
        ++decoded;
        return kBytes + kBytes;
    };
    const auto together = std::make_shared<DecodedSamples>(decode, latest);
    SampleLayout second = kLayout;
    second.offset += kLayout.bytes();
    const ReadRow rows = rowsOfDecoded(together, kLayout, "a file");
    const ReadRow next = rowsOfDecoded(together, second, "a file");
    EXPECT_EQ(readRowOf(rows, 0), (std::vector<double>{1, 2, 3}));
    EXPECT_EQ(readRowOf(next, 0), (std::vector<double>{1, 2, 3}));
    EXPECT_EQ(decoded, 1);
    const auto other = std::make_shared<DecodedSamples>(decode, latest);
    (void)readRowOf(rowsOfDecoded(other, kLayout, "a file"), 0);
    EXPECT_EQ(decoded, 2);
    EXPECT_EQ(readRowOf(rows, 1), (std::vector<double>{4, 5, 6}));
    EXPECT_EQ(decoded, 3) << "the samples of two are in memory";
}

TEST(SampleRows, LeavesOutWhatAMaskMarks) {
    const MemoryBytes bytes(kBytes, "a file");
    const ReadRow mask = [](int row, RowRoom&, double* numbers) {
        std::fill_n(numbers, kImageSize.columns, 0.0);
        numbers[row] = 1.0;
    };
    const std::vector<double> second = readRowOf(masked(rowsOf(bytes, kLayout), 3, mask), 1);
    EXPECT_EQ(second[0], 4.0);
    EXPECT_TRUE(std::isnan(second[1]));
    EXPECT_EQ(second[2], 6.0);
}

TEST(SampleRows, ReplacesNumbers) {
    const MemoryBytes bytes(kBytes, "a file");
    const ReadRow rows =
        replaced(rowsOf(bytes, kLayout), 3, [](double number) { return 10.0 * number; });
    EXPECT_EQ(readRowOf(rows, 1), (std::vector<double>{40, 50, 60}));
}

}  // namespace
}  // namespace asperity
