#include "core/Error.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "core/io/heightmap/SampleRows.h"
#include "core/io/heightmap/ScanImage.h"

#include <gtest/gtest.h>

namespace asperity::test {

TEST(StoredRows, WhatCannotBeDecodedTakesNoRoomForItsPixels) {
    StoredChannel stored;
    stored.channel.map = emptyMap({65536, 65536}, 0.0, 0.0);  // 32 GiB of heights
    stored.readRow = [](int, RowRoom&, double*) {
        throw InputError("scan.png", "byte 33", "it cannot be decoded");
    };
    const MemoryBytes bytes("", "scan.png");
    EXPECT_THROW((void)readHeightMap(stored, bytes), InputError);
    EXPECT_THROW((void)readScanMap(stored, bytes), InputError);
}

}  // namespace asperity::test
