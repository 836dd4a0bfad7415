#include "core/io/heightmap/ScanFile.h"

#include "core/Error.h"
#include "core/io/heightmap/HeightMapWriter.h"
#include "core/io/heightmap/HeightStatistics.h"
#include "tests/core/io/heightmap/BumpyMap.h"
#include "tests/core/io/heightmap/MapStatistics.h"
#include "tests/core/io/heightmap/SyntheticScans.h"
#include "tests/support/Refusal.h"
#include "tests/support/ScratchFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <functional>
#include <utility>

// Files that others write to while they are read: refused, never a signal.

namespace asperity::test {

namespace {

using testing::AnyOf;
using testing::HasSubstr;

/// Does something to the file when the work has come so far.
class Meanwhile : public Progress {
public:
    Meanwhile(double fraction, std::function<void()> action)
        : fraction_(fraction), action_(std::move(action)) {}

    void report(double fraction) override {
        if (fraction >= fraction_ && action_) {
            std::exchange(action_, nullptr)();
        }
    }
    [[nodiscard]] bool isCanceled() const override { return false; }

private:
    double fraction_;
    std::function<void()> action_;
};

void shorten(const std::filesystem::path& path) {
    std::filesystem::resize_file(path, std::filesystem::file_size(path) / 20);
}

/// Writes into the file, without another size.
void writeInto(const std::filesystem::path& path) {
    const auto before = std::filesystem::last_write_time(path);
    std::fstream stream(path, std::ios::in | std::ios::out | std::ios::binary);
    stream.seekp(-8, std::ios::end);
    stream << "12345678";
    stream.close();
    std::filesystem::last_write_time(path, before + std::chrono::seconds(1));
}

/// A scan of each format; two threads share the larger ones.
class ChangingFile : public testing::TestWithParam<std::string> {
protected:
    void SetUp() override {
        const std::string name = GetParam();
        path = folder.file(name);
        if (name == "scan.spm") {
            NanoscopeText text;
            text.lines = "2000";
            text.samples = "300";
            text.dataLength = std::to_string(300 * 2000 * 2);
            (void)folder.write(name, nanoscopeFile(text, std::vector<std::int32_t>(600000, 7)));
        } else if (name == "masked.gwy") {
            HeightMap map = bumpyMap(700, 500);
            map.invalid.assign(map.heights.size(), false);
            map.invalid[350] = true;
            writeHeightMap(path, map, {});
        } else {
            const int rows = name == "small.gsf" ? 40 : 500;
            writeHeightMap(path, bumpyMap(700, rows), {});
        }
    }

    /// Checks the refusals when that happens to the file before, in the middle and at the end of a
    /// load.
    void expectRefusals(const std::function<void(const std::filesystem::path&)>& change) {
        for (const double fraction : {0.0, 0.5}) {
            const ScanFile one(path);
            Meanwhile ofOne(fraction, [&] { change(path); });
            EXPECT_THAT(refusalOf([&] { (void)one.readHeightScan("", &ofOne); }), said);
            SetUp();
            const ScanFile two(path);
            Meanwhile ofTwo(fraction, [&] { change(path); });
            EXPECT_THAT(refusalOf([&] { (void)two.readHeightChannel("", &ofTwo); }), said);
            SetUp();
        }
        const ScanFile file(path);
        (void)file.readHeightScan("");
        change(path);
        EXPECT_THAT(refusalOf([&] { (void)file.sha256(); }), said);
        EXPECT_THAT(refusalOf([&] {
                        file.forEachRow(file.contents().channels.front(),
                                        [](int, std::span<const double>) {});
                    }),
                    said);
    }

    ScratchFolder folder;
    std::filesystem::path path;
    testing::Matcher<std::string> said = AnyOf(HasSubstr("became shorter while it was read"),
                                               HasSubstr("changed while it was read"));
};

TEST_P(ChangingFile, ThatBecomesShorterIsRefused) { expectRefusals(shorten); }

TEST_P(ChangingFile, ThatIsWrittenToIsRefused) { expectRefusals(writeInto); }

TEST_P(ChangingFile, ThatIsReplacedIsTheOneThatWasOpened) {
    const ScanFile before(path);
    const std::string hash = before.sha256();
    Meanwhile replaced(0.5,
                       [&] { std::filesystem::rename(folder.write("new", "another file"), path); });
    EXPECT_EQ(before.readHeightScan("", &replaced).map.rows,
              before.contents().channels.front().map.rows);
    EXPECT_EQ(before.sha256(), hash);
    EXPECT_THROW(ScanFile{path}, InputError);
}

INSTANTIATE_TEST_SUITE_P(Formats, ChangingFile,
                         testing::Values("scan.spm", "scan.gwy", "masked.gwy", "scan.gsf",
                                         "small.gsf"),
                         [](const auto& file) {
                             std::string name = file.param;
                             name.erase(name.find('.'), 1);
                             return name;
                         });

TEST(ScanFile, RowsAreThoseOfTheMap) {
    const ScratchFolder folder;
    HeightMap map = bumpyMap(37, 23);
    map.invalid.assign(map.heights.size(), false);
    map.invalid[50] = true;
    writeHeightMap(folder.file("map.gwy"), map, {});
    const ScanFile file(folder.file("map.gwy"));
    const ScanChannel& channel = file.contents().channels.front();
    EXPECT_TRUE(channel.map.heights.empty());
    const HeightStatistics streamed = heightStatistics([&](const TakeRow& take) {
        file.forEachRow(channel, [&](int, std::span<const double> values) { take(values); });
    });
    const HeightStatistics whole =
        statisticsOf(readHeightMapFile(folder.file("map.gwy")).channels.front().map);
    EXPECT_EQ(streamed.lowest, whole.lowest);
    EXPECT_EQ(streamed.highest, whole.highest);
    EXPECT_EQ(streamed.mean, whole.mean);
    EXPECT_EQ(streamed.rms, whole.rms);
    EXPECT_EQ(streamed.invalidPixels, 1U);
}

}  // namespace
}  // namespace asperity::test
