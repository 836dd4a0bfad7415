#include "core/Error.h"
#include "core/io/FileBytes.h"
#include "tests/core/io/heightmap/RealScans.h"
#include "tests/support/ReferenceTable.h"

#include <gtest/gtest.h>

namespace asperity::test {

namespace {

std::string hashOf(const std::string& bytes) { return sha256Of(MemoryBytes(bytes, "bytes")); }

}  // namespace

TEST(FileHash, IsSha256) {
    // The example messages of FIPS 180-4.
    EXPECT_EQ(hashOf("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(hashOf(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(hashOf(std::string(1000000, 'a')),
              "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(FileHash, IsMd5) {
    // RFC 1321, A.5.
    EXPECT_EQ(md5Of(MemoryBytes("", "bytes")), "d41d8cd98f00b204e9800998ecf8427e");
    EXPECT_EQ(md5Of(MemoryBytes("message digest", "bytes")), "f96b697d7cb7938d525a2f31aaf161d0");
}

TEST(FileHash, RealFilesAreThoseOfTheManifest) {
    ASPERITY_NEEDS_SHARED_DATA();
    const ReferenceTable table(sharedData("afm/MANIFEST.csv"));
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const std::string& file = table.text(row, "file");
        EXPECT_EQ(sha256Of(FileBytes(sharedData("afm/" + file))), table.text(row, "sha256"))
            << file;
    }
}

}  // namespace asperity::test
