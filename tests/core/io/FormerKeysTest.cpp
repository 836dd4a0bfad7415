#include "core/io/FormerKeys.h"

#include "core/io/recording/ColumnList.h"
#include "core/io/recording/TickLog.h"
#include "core/io/tables/CsvTable.h"
#include "core/scene/SceneFields.h"
#include "core/scene/SettingFields.h"
#include "core/scene/Validity.h"
#include "tests/support/ScratchFolder.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

namespace asperity {
namespace {

/// All keys that are written today where a renamed one may be.
std::set<std::string, std::less<>> writtenKeys() {
    const test::ScratchFolder scratch;
    ForceLogWriter(scratch.file("log")).close();
    TickInputWriter(scratch.file("input")).close();
    writeTickMemory(scratch.file("memory"), {});
    std::set<std::string, std::less<>> keys;
    for (const char* file : {"log", "input", "memory"}) {
        const std::vector<std::string> columns = readCsv(scratch.file(file)).columns();
        keys.insert(columns.begin(), columns.end());
    }
    for (const SceneField& field : sceneFields()) {
        keys.insert(field.key);
    }
    const Settings any;
    listSettings(any, [&keys](const SettingField& field, const auto& /*value*/) {
        keys.insert(field.column);
    });
    for (const ValidityTraits& flag : kValidityTraits) {
        keys.insert(flag.key);
    }
    keys.insert({"window/shown/tool/Force cycles", "Force cycles"});
    return keys;
}

TEST(FormerKeys, HaveACurrentNameThatIsWritten) {
    const auto written = writtenKeys();
    for (const auto& [former, current] : kFormerKeys) {
        EXPECT_TRUE(written.contains(current)) << current;
        EXPECT_FALSE(written.contains(former)) << former;
        EXPECT_EQ(currentKey(former), current) << "once";
        EXPECT_EQ(currentKey(current), current);
        EXPECT_EQ(unitOfColumn(former), unitOfColumn(current)) << former;
    }
}

TEST(FormerKeys, LeaveOtherKeysAsTheyAre) {
    for (const char* key : {"", "hand", "foot", "foot4_x_m", "hand_x", "base_x_m"}) {
        EXPECT_EQ(currentKey(key), key);
    }
}

TEST(FormerKeys, StayWhereTheCurrentNameIsGivenToo) {
    EXPECT_EQ(currentKeys({"hand_x_m", "time_s", "hand_y_m", "device_x_m"}),
              (std::vector<std::string>{"hand_x_m", "time_s", "device_y_m", "device_x_m"}));
    EXPECT_EQ(currentKeys({"hand_x_m", "hand_x_m"}),
              (std::vector<std::string>{"device_x_m", "device_x_m"}))
        << "two of the same name stay two";
}

TEST(FormerKeys, OfFlagsAreWords) {
    EXPECT_EQ(currentFlags("-"), "-");
    EXPECT_EQ(currentFlags(""), "");
    EXPECT_EQ(currentFlags("several_feet"), "several_contact_points");
    EXPECT_EQ(currentFlags("foot_not_found|thin_film|feet_unproven"),
              "closest_point_not_found|thin_film|search_not_exhaustive");
    EXPECT_EQ(currentFlags("thin_film|several_feet_more"), "thin_film|several_feet_more");
}

}  // namespace
}  // namespace asperity
