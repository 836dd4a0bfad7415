#include "core/io/ByteReader.h"
#include "tests/core/io/heightmap/BoundedRead.h"
#include "tests/support/Sanitized.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

// Small files that promise much: the memory follows what they hold.

namespace asperity::test {

namespace {

/// A .vti of 10,000 x 10,000 doubles with these bytes as its compressed values.
std::string largeVti(const std::string& compressor, const std::string& values) {
    return R"(<VTKFile type="ImageData" byte_order="LittleEndian" header_type="UInt64" )"
           R"(compressor="vtk)" +
           compressor +
           R"(DataCompressor"><ImageData WholeExtent="0 9999 0 9999 0 0" Spacing="1 1 1">)"
           R"(<Piece Extent="0 9999 0 9999 0 0"><PointData><DataArray Name="z" type="Float64" )"
           R"(format="appended" offset="0"/></PointData></Piece></ImageData><AppendedData )"
           R"(encoding="raw">_)" +
           values + "</AppendedData></VTKFile>";
}

}  // namespace

TEST(MemoryBounds, HoldForBlocksThatCannotHoldTheirValues) {
    if (kSanitized) {
        GTEST_SKIP() << "a sanitizer takes memory of its own";
    }
    constexpr std::uint64_t kMax = 50'000'000;
    for (const char* const compressor : {"ZLib", "LZ4", "LZMA"}) {
        std::string values;
        for (const std::uint64_t count : {1U, 800'000'000U, 0U, 100U}) {
            appendLittleEndian(values, count);
        }
        const BoundedRead read =
            readBounded(largeVti(compressor, values + std::string(100, 'x')), kMax);
        EXPECT_EQ(read.failure, "") << compressor;
        EXPECT_FALSE(read.isRead) << compressor;
        EXPECT_LT(read.memory, kMax) << compressor;
    }
}

/// A point has x, y and z until its height is in the grid; the map that is read from there makes
/// four numbers a point.
TEST(MemoryBounds, HoldForPoints) {
    if (kSanitized) {
        GTEST_SKIP() << "a sanitizer takes memory of its own";
    }
    constexpr std::uint64_t kSide = 2000;
    constexpr std::uint64_t kMap = kSide * kSide * sizeof(double);
    std::string bytes;
    for (std::uint64_t y = 0; y < kSide; ++y) {
        for (std::uint64_t x = 0; x < kSide; ++x) {
            bytes += std::to_string(x) + " " + std::to_string(y) + " 1\n";
        }
    }
    const BoundedRead read = readBounded(bytes, 8 * kMap);
    EXPECT_TRUE(read.isRead) << read.failure;
    EXPECT_LT(read.memory, 4 * kMap + kMap / 2);
}

/// Numbers as text are decoded into memory that does not grow.
TEST(MemoryBounds, HoldForNumbersAsText) {
    if (kSanitized) {
        GTEST_SKIP() << "a sanitizer takes memory of its own";
    }
    constexpr std::uint64_t kSide = 2048;
    constexpr std::uint64_t kMap = kSide * kSide * sizeof(double);
    std::string numbers;
    for (std::uint64_t i = 0; i < kSide * kSide; ++i) {
        numbers += "1 ";
    }
    const std::string bytes =
        R"(<VTKFile type="ImageData" byte_order="LittleEndian"><ImageData )"
        R"(WholeExtent="0 2047 0 2047 0 0" Spacing="1 1 1"><Piece Extent="0 2047 0 2047 0 0">)"
        R"(<PointData><DataArray Name="z" type="Float64" format="ascii">)" +
        numbers + "</DataArray></PointData></Piece></ImageData></VTKFile>";
    const BoundedRead read = readBounded(bytes, 2 * kMap + kMap / 2);
    EXPECT_TRUE(read.isRead) << read.failure;
}

}  // namespace asperity::test
