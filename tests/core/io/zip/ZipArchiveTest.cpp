#include "core/io/zip/ZipArchive.h"

#include "core/Error.h"
#include "core/io/ByteReader.h"
#include "tests/core/io/heightmap/ZipFiles.h"
#include "tests/support/Refusal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

namespace asperity::test {

namespace {

using testing::HasSubstr;
using testing::StartsWith;

const std::string& manyNumbers() {
    static const std::string kText = [] {
        std::string text;
        for (int i = 0; i < 200000; ++i) {
            text += std::to_string(i);
        }
        return text;
    }();
    return kText;
}

std::string smallArchive() {
    return zipFile({{"folder/packed.txt", manyNumbers()},
                    {"stored.bin", manyNumbers(), false},
                    {"empty", ""}});
}

/// Bytes some of which cannot be read any more.
class LostBytes final : public ByteSource {
public:
    explicit LostBytes(std::string_view bytes) : ByteSource("lost.zip"), bytes_(bytes) {}

    [[nodiscard]] std::uint64_t size() const override { return bytes_.size(); }
    void read(std::uint64_t offset, std::span<char> bytes) const override {
        if (offset < 20000 && offset + bytes.size() > 10000) {
            throw InputError(name(), "byte " + std::to_string(offset), "the file became shorter");
        }
        std::ranges::copy(bytes_.substr(offset, bytes.size()), bytes.begin());
    }
    void requireUnchanged() const override {}

private:
    std::string_view bytes_;
};

}  // namespace

TEST(ZipArchive, ListsEntriesWithTheirSizes) {
    const std::string bytes = smallArchive();
    const MemoryBytes source(bytes, "a.zip");
    const ZipArchive archive(source);
    ASSERT_EQ(archive.entries().size(), 3U);
    const ZipEntry& packed = archive.entries()[0];
    EXPECT_EQ(packed.name, "folder/packed.txt");
    EXPECT_EQ(packed.baseName(), "packed.txt");
    EXPECT_EQ(packed.size, manyNumbers().size());
    EXPECT_FALSE(packed.isStored);
    EXPECT_TRUE(archive.entries()[1].isStored);
    EXPECT_EQ(archive.find("empty")->size, 0U);
    EXPECT_EQ(archive.find("none"), nullptr);
}

TEST(ZipArchive, DecodesCompressedAndStoredEntries) {
    const std::string bytes = smallArchive();
    const MemoryBytes source(bytes, "a.zip");
    const ZipArchive archive(source);
    for (const ZipEntry& entry : archive.entries()) {
        const std::string& expected = entry.size == 0 ? "" : manyNumbers();
        EXPECT_EQ(archive.decoded(entry, entry.size), expected) << entry.name;
        const auto content = archive.source(entry, entry.size);
        EXPECT_EQ(content->size(), entry.size);
        EXPECT_EQ(content->start(entry.size), expected) << entry.name;
        EXPECT_EQ(content->name(), "a.zip: " + entry.name);
    }
}

TEST(ZipArchive, SourcesOutliveTheArchiveAndServeTwoThreads) {
    const std::string bytes = smallArchive();
    const MemoryBytes source(bytes, "a.zip");
    for (const std::size_t index : {0U, 1U}) {
        std::shared_ptr<const ByteSource> content;
        {
            const ZipArchive archive(source);
            content = archive.source(archive.entries()[index], manyNumbers().size());
        }
        const auto readAll = [&content](std::size_t step) {
            for (std::size_t offset = 0; offset + 100 < manyNumbers().size(); offset += step) {
                std::string part(100, '\0');
                content->read(offset, part);
                ASSERT_EQ(part, manyNumbers().substr(offset, 100));
            }
        };
        std::thread other(readAll, 977);
        readAll(1009);
        other.join();
    }
}

TEST(ZipArchive, RefusesToReadBehindTheEndOfAnEntry) {
    const std::string bytes = smallArchive();
    const MemoryBytes source(bytes, "a.zip");
    const ZipArchive archive(source);
    for (const char* name : {"folder/packed.txt", "stored.bin"}) {
        const auto content = archive.source(*archive.find(name), manyNumbers().size());
        std::string part(100, '\0');
        EXPECT_THAT(refusalOf([&] { content->read(manyNumbers().size() - 99, part); }),
                    AllOf(StartsWith("a.zip: "), HasSubstr(name)));
    }
}

TEST(ZipArchive, RefusesAnEntryThatIsLargerThanExpected) {
    const std::string bytes = zipFile({{"bomb", std::string(100U << 20U, '\0')}});
    EXPECT_LT(bytes.size(), 200000U);
    const MemoryBytes source(bytes, "a.zip");
    const ZipArchive archive(source);
    EXPECT_EQ(refusalOf([&] { (void)archive.source(archive.entries()[0], 1000); }),
              "a.zip: bomb: it holds 104857600 bytes; at most 1000 are expected");
}

TEST(ZipArchive, RefusesAnEntryThatIsNotWhatTheDirectoryLists) {
    std::string bytes = zipFile({{"data", std::string(1000, 'x')}});
    // The size in the directory, 24 bytes behind its mark; that in the local header stays.
    const std::size_t directory = bytes.find("PK\1\2");
    for (const char size : {'\x01', '\x7F'}) {
        bytes[directory + 25] = size;
        const MemoryBytes source(bytes, "a.zip");
        EXPECT_THAT(refusalOf([&] {
                        const ZipArchive archive(source);
                        (void)archive.decoded(archive.entries()[0], 1U << 20U);
                    }),
                    AllOf(StartsWith("a.zip: data: "), HasSubstr("zip archive")));
    }
}

/// libzip 1.7 crashes when it seeks in one.
TEST(ZipArchive, RefusesAStoredEntryOfNoBytesThatIsListedWithSome) {
    std::string bytes = zipFile({{"data", "0123456789", false}});
    // The bytes in the archive, 20 bytes behind the mark of the directory.
    bytes[bytes.find("PK\1\2") + 20] = '\0';
    const MemoryBytes source(bytes, "a.zip");
    const ZipArchive archive(source);
    EXPECT_THAT(refusalOf([&] { (void)archive.source(archive.entries()[0], 10)->start(10); }),
                StartsWith("a.zip: data: "));
}

TEST(ZipArchive, ReadsAnEmptyStoredEntry) {
    const std::string bytes = zipFile({{"empty", "", false}});
    const MemoryBytes source(bytes, "a.zip");
    const ZipArchive archive(source);
    EXPECT_EQ(archive.source(archive.entries()[0], 10)->start(10), "");
}

TEST(ZipArchive, ChecksTheCrc) {
    std::string bytes = zipFile({{"data", "0123456789", false}});
    bytes[bytes.find("0123456789") + 4] = 'x';
    const MemoryBytes source(bytes, "a.zip");
    const ZipArchive archive(source);
    EXPECT_THAT(refusalOf([&] { (void)archive.decoded(archive.entries()[0], 10); }),
                AllOf(StartsWith("a.zip: data: "), HasSubstr("CRC")));
}

TEST(ZipArchive, RefusesDamagedArchives) {
    const std::string bytes = smallArchive();
    for (const std::size_t length : {std::size_t{0}, std::size_t{4}, bytes.size() - 1}) {
        const MemoryBytes source(std::string_view(bytes).substr(0, length), "a.zip");
        EXPECT_THAT(refusalOf([&] { const ZipArchive archive(source); }),
                    StartsWith("a.zip: the zip archive is damaged or truncated: "));
    }
}

/// libzip is C: an exception must not run through it, and its cause must not get lost.
TEST(ZipArchive, AFileThatBecomesShorterIsNamedAsSuch) {
    const std::string bytes = smallArchive();
    const LostBytes source(bytes);
    const ZipArchive archive(source);
    EXPECT_THAT(refusalOf([&] { (void)archive.decoded(archive.entries()[0], 1U << 22U); }),
                HasSubstr("the file became shorter"));
}

constexpr std::uint32_t kManyEntries = 600'001;
constexpr std::uint32_t kEntryBytes = 47;

/// Directory entries behind the mark of an archive.
std::string entriesOnly(std::uint32_t count) {
    std::string bytes = "PK\3\4";
    for (std::uint32_t i = 0; i < count; ++i) {
        bytes += "PK\1\2" + std::string(24, '\0') + '\1' + std::string(17, '\0') + "a";
    }
    return bytes;
}

/// The end of an archive whose directory lies behind its first mark.
std::string endRecord(std::uint32_t directoryBytes, const std::string& comment = {}) {
    std::string bytes = "PK\5\6" + std::string(4, '\0');
    const auto entries =
        static_cast<std::uint16_t>(std::min<std::uint32_t>(directoryBytes / kEntryBytes, 0xFFFF));
    appendLittleEndian(bytes, entries);
    appendLittleEndian(bytes, entries);
    appendLittleEndian(bytes, directoryBytes);
    appendLittleEndian(bytes, std::uint32_t{4});
    appendLittleEndian(bytes, static_cast<std::uint16_t>(comment.size()));
    return bytes + comment;
}

/// The 64-bit end of an archive and its locator.
std::string endRecord64(std::uint64_t offset, std::uint64_t entries) {
    std::string bytes = "PK\6\6";
    appendLittleEndian(bytes, std::uint64_t{44});
    bytes += std::string("\x2D\0\x2D\0", 4) + std::string(8, '\0');
    for (const std::uint64_t number : {entries, entries, entries * kEntryBytes, std::uint64_t{4}}) {
        appendLittleEndian(bytes, number);
    }
    bytes += "PK\6\7" + std::string(4, '\0');
    appendLittleEndian(bytes, offset);
    appendLittleEndian(bytes, std::uint32_t{1});
    return bytes;
}

/// 47 bytes of the file took 350 of memory.
TEST(ZipArchive, RefusesMoreEntriesThanAnArchiveOfItsSizeHas) {
    const std::string entries = entriesOnly(kManyEntries);
    const std::string end64 = endRecord64(entries.size(), kManyEntries);
    const std::string shortEnd = endRecord(kEntryBytes);
    for (const std::string& end :
         {endRecord(kManyEntries * kEntryBytes), end64 + endRecord(0xFFFFFFFF),
          end64 + shortEnd,                         // which libzip leaves unread
          end64 + endRecord(0xFFFFFFFF, shortEnd),  // which libzip reads as well
          endRecord(kManyEntries * kEntryBytes, "\1" + shortEnd + "end")}) {
        const std::string bytes = entries + end;
        const MemoryBytes source(bytes, "many.zip");
        EXPECT_EQ(refusalOf([&] { (void)ZipArchive(source); }),
                  "many.zip: directory of the zip archive: it lists more than 600000 files; no "
                  "archive of this size has so many");
    }
}

/// Each directory that an end record names is read: a hundred of them cost a hundred times as much.
TEST(ZipArchive, RefusesAFewEntriesListedByManyEnds) {
    std::string ends;
    for (int i = 0; i < 7; ++i) {
        ends += endRecord(100'000 * kEntryBytes);
    }
    const std::string bytes = entriesOnly(100'000) + endRecord(100'000 * kEntryBytes, ends);
    const MemoryBytes source(bytes, "many.zip");
    EXPECT_THAT(refusalOf([&] { (void)ZipArchive(source); }), HasSubstr("more than 600000 files"));
}

TEST(ZipArchive, OpensWithA64BitEndOrAComment) {
    const std::string entries = entriesOnly(3);
    const std::string end64 = endRecord64(entries.size(), 3);
    for (const std::string& end :
         {endRecord(3 * kEntryBytes), end64 + endRecord(0xFFFFFFFF),
          end64 + endRecord(3 * kEntryBytes),  // as Python has it for 65536 files and more
          endRecord(3 * kEntryBytes, "a comment"), endRecord(3 * kEntryBytes, "a PK\5\6 comment"),
          endRecord(3 * kEntryBytes, std::string(65535, 'c'))}) {
        const std::string bytes = entries + end;
        const MemoryBytes source(bytes, "a.zip");
        EXPECT_EQ(ZipArchive(source).entries().size(), 3U);
        EXPECT_EQ(zipDirectory(source), entries.substr(4));
    }
}

/// The end of the inner archive lies near that of the outer one.
TEST(ZipArchive, MayHoldAnotherArchive) {
    const std::string bytes = zipFile({{"a", "1"}, {"inner.zip", zipFile({{"b", "2"}}), false}});
    const MemoryBytes source(bytes, "a.zip");
    EXPECT_EQ(ZipArchive(source).entries().size(), 2U);
    EXPECT_THAT(*zipDirectory(source), HasSubstr("inner.zip"));
}

TEST(ZipDirectory, EntriesAreCountedUpToTheFirstThatIsDamaged) {
    std::string bytes = smallArchive();
    EXPECT_TRUE(zipListsMoreThan(2, MemoryBytes(bytes, "a.zip")));
    EXPECT_FALSE(zipListsMoreThan(3, MemoryBytes(bytes, "a.zip")));
    bytes[bytes.rfind("PK\1\2")] = 'x';
    EXPECT_TRUE(zipListsMoreThan(1, MemoryBytes(bytes, "a.zip")));
    EXPECT_FALSE(zipListsMoreThan(2, MemoryBytes(bytes, "a.zip")));
    EXPECT_FALSE(zipListsMoreThan(0, MemoryBytes("PK\5\6", "a.zip")));
}

TEST(ZipDirectory, HoldsTheNamesOfTheEntries) {
    const std::string bytes = smallArchive();
    const MemoryBytes source(bytes, "a.zip");
    EXPECT_TRUE(isZip(source));
    const std::optional<std::string> directory = zipDirectory(source);
    ASSERT_TRUE(directory);
    EXPECT_THAT(*directory, AllOf(HasSubstr("folder/packed.txt"), HasSubstr("stored.bin")));
    const MemoryBytes text("no zip", "a.txt");
    EXPECT_FALSE(isZip(text));
    for (std::size_t length = 0; length < bytes.size(); length += bytes.size() / 100) {
        EXPECT_FALSE(zipDirectory(MemoryBytes(std::string_view(bytes).substr(0, length), "cut")));
    }
}

TEST(ZipDirectory, MayLieInA64BitRecord) {
    std::string directory = "PK\1\2 main.xml";
    std::string bytes = "PK\3\4" + directory;
    const auto number = [](std::uint64_t value, std::size_t count) {
        std::string text;
        for (std::size_t i = 0; i < count; ++i) {
            text += static_cast<char>(value >> (8 * i) & 0xFFU);
        }
        return text;
    };
    const std::uint64_t record = bytes.size();
    bytes += "PK\6\6" + std::string(36, '\0') + number(directory.size(), 8) + number(4, 8);
    bytes += "PK\6\7" + std::string(4, '\0') + number(record, 8) + std::string(4, '\0');
    bytes += "PK\5\6" + std::string(8, '\xFF') + std::string(8, '\xFF') + std::string(2, '\0');
    EXPECT_EQ(zipDirectory(MemoryBytes(bytes, "a.zip")), directory);
}

}  // namespace asperity::test
