#include "hardware/DeviceRegistry.h"

#include "core/Error.h"
#include "core/words/DeviceWords.h"
#include "hardware/spacemouse/SpaceMouse.h"
#include "hardware/woodenhaptics/WoodenHaptics.h"
#include "tests/hardware/FakeHid.h"
#include "tests/support/Places.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fnmatch.h>
#include <fstream>
#include <iomanip>
#include <memory>
#include <set>
#include <sstream>
#include <utility>

namespace asperity::test {
namespace {

HidDeviceInfo withIds(std::uint16_t vendorId, std::uint16_t productId) {
    HidDeviceInfo device = spaceMouseInfo();
    device.vendorId = vendorId;
    device.productId = productId;
    return device;
}

HidDeviceInfo teensyInfo() {
    return {.path = "/dev/hidraw4",
            .vendorId = 0x16c0,
            .productId = 0x0486,
            .product = "WoodenHaptics",
            .usages = {{.page = 0xFFAB, .id = 0x200}}};
}

DeviceSite siteOf(HidTransport& hid) {
    return {.hid = [&hid]() -> HidTransport& { return hid; },
            .data = test::dataFolder(),
            .start = {1e-9, 2e-9, 3e-9}};
}

/// Without mouse and keyboard and the simulated device, which are always there.
std::vector<DeviceDescription> listedHid(HidTransport& hid) {
    std::vector<DeviceDescription> list = listDevices(siteOf(hid));
    std::erase_if(list, [](const DeviceDescription& device) { return device.path.empty(); });
    return list;
}

TEST(DeviceRegistry, KnowsSpaceMiceOfBothVendorIds) {
    for (const auto& [vendor, product] : {std::pair{0x046d, 0xc603},
                                          {0x046d, 0xc626},
                                          {0x046d, 0xc62b},
                                          {0x046d, 0xc640},
                                          {0x256f, 0xc62e},
                                          {0x256f, 0xc633},
                                          {0x256f, 0xc635},
                                          {0x256f, 0xc652}}) {
        EXPECT_TRUE(isSpaceMouse(
            withIds(static_cast<std::uint16_t>(vendor), static_cast<std::uint16_t>(product))))
            << std::hex << vendor << ':' << product;
    }
}

TEST(DeviceRegistry, CadMiceAndOtherDevicesOfTheSameVendorsAreNoSpaceMice) {
    for (const auto& [vendor, product] : {std::pair{0x046d, 0xc602},
                                          {0x046d, 0xc641},
                                          {0x046d, 0xc283},
                                          {0x256f, 0xc62d},
                                          {0x256f, 0xc650},
                                          {0x256f, 0xc651},
                                          {0x256f, 0xc653},
                                          {0x256f, 0xc658},
                                          {0x16c0, 0xc635}}) {
        EXPECT_FALSE(isSpaceMouse(
            withIds(static_cast<std::uint16_t>(vendor), static_cast<std::uint16_t>(product))))
            << std::hex << vendor << ':' << product;
    }
}

TEST(DeviceRegistry, ANodeWithoutSixAxesIsNoSpaceMouse) {
    HidDeviceInfo receiver = withIds(0x256f, 0xc652);
    receiver.usages = {{.page = 1, .id = 6}, {.page = 12, .id = 1}};
    EXPECT_FALSE(isSpaceMouse(receiver));
    receiver.usages.push_back({.page = 1, .id = 8});
    EXPECT_TRUE(isSpaceMouse(receiver));
}

TEST(DeviceRegistry, EachDriverIsOnItsOwnInReportsAndInTheList) {
    std::set<std::string> keys;
    std::set<std::string> labels;
    for (const DeviceDriver* const driver : deviceDrivers()) {
        EXPECT_TRUE(keys.insert(driver->key).second) << driver->key;
        EXPECT_TRUE(labels.insert(driver->label).second) << driver->label;
        EXPECT_FALSE(driver->senses.empty()) << driver->key;
    }
    EXPECT_FALSE(keys.contains(""));
    EXPECT_FALSE(labels.contains(""));
}

TEST(DeviceRegistry, EachDriverOpensADeviceThatIsWhatItsRowSays) {
    FakeHid hid;
    const DeviceSite site = siteOf(hid);
    for (const DeviceDriver* const driver : deviceDrivers()) {
        const std::unique_ptr<HapticDevice> opened = driver->open(site);
        EXPECT_EQ(opened->specification().rendersForce(), driver->rendersForce) << driver->key;
        const bool isHid = opened->piloted() == nullptr;
        EXPECT_EQ(wordsOf(opened->status()),
                  isHid ? "no " + std::string(driver->label) + " is plugged in" : "");
    }
    const std::unique_ptr<HapticDevice> pointer = pointerDriver().open(site);
    EXPECT_EQ(pointer->advance(0.0).position, site.start);
}

TEST(DeviceRegistry, ListsWhatIsAlwaysThereWhereTheTableHasIt) {
    FakeHid hid({teensyInfo(), spaceMouseInfo()});
    std::vector<std::string> listed;
    for (const DeviceDescription& device : listDevices(siteOf(hid))) {
        listed.push_back(device.name);
    }
    EXPECT_EQ(listed, (std::vector<std::string>{"mouse and keyboard", "SpaceMouse Compact",
                                                "simulated device", "WoodenHaptics"}));
}

TEST(DeviceRegistry, ADeviceWhoseFileIsMissingCannotBeOpened) {
    FakeHid hid;
    EXPECT_THROW((void)woodenHapticsDriver().open(
                     {.hid = [&hid]() -> HidTransport& { return hid; }, .data = "/nowhere"}),
                 InputError);
}

TEST(DeviceRegistry, SaysWhatASpaceMouseCanDo) {
    FakeHid hid;
    hid.plug(spaceMouseInfo());
    const std::vector<DeviceDescription> list = listedHid(hid);
    ASSERT_EQ(list.size(), 1U);
    EXPECT_EQ(list[0].name, "SpaceMouse Compact");
    EXPECT_EQ(list[0].driver, &spaceMouseDriver());
    EXPECT_EQ(list[0].path, "/dev/hidraw7");
    EXPECT_EQ(list[0].vendorId, 0x256f);
    EXPECT_EQ(list[0].productId, 0xc635);
    EXPECT_EQ(list[0].driver->senses,
              (std::vector<std::string>{"x", "y", "z", "rx", "ry", "rz", "buttons"}));
    EXPECT_FALSE(list[0].driver->rendersForce);
    EXPECT_TRUE(list[0].usable());
}

TEST(DeviceRegistry, SaysWhatAWoodenHapticsCanDo) {
    FakeHid hid({teensyInfo()});
    const std::vector<DeviceDescription> list = listedHid(hid);
    ASSERT_EQ(list.size(), 1U);
    EXPECT_EQ(list[0].driver, &woodenHapticsDriver());
    EXPECT_EQ(list[0].driver->senses, (std::vector<std::string>{"x", "y", "z", "buttons"}));
    EXPECT_TRUE(list[0].driver->rendersForce);
    EXPECT_TRUE(list[0].usable());
}

TEST(DeviceRegistry, TheSerialPortOfATeensyIsNoWoodenHaptics) {
    HidDeviceInfo device = teensyInfo();
    EXPECT_TRUE(isWoodenHaptics(device));
    device.usages = {{.page = 0xFFC9, .id = 4}};
    EXPECT_FALSE(isWoodenHaptics(device));
    EXPECT_FALSE(isWoodenHaptics(withIds(0x16c0, 0x0487)));
    EXPECT_TRUE(isWoodenHaptics(withIds(0x1234, 0x0006)));
}

TEST(DeviceRegistry, ListsUnknownDevicesAsNotUsable) {
    FakeHid hid;
    hid.plug({.path = "/dev/hidraw0", .vendorId = 0x1234, .productId = 1, .manufacturer = "Acme"});
    hid.plug(spaceMouseInfo());
    const std::vector<DeviceDescription> list = listedHid(hid);
    ASSERT_EQ(list.size(), 2U);
    EXPECT_TRUE(list[0].usable());
    EXPECT_EQ(list[1].name, "Acme HID device");
    EXPECT_EQ(list[1].driver, nullptr);
    EXPECT_EQ(list[1].obstacle, "no driver for this device");
}

TEST(DeviceRegistry, NamesTheRulesFileWhenPermissionIsMissing) {
    FakeHid hid;
    HidDeviceInfo device = spaceMouseInfo();
    device.permitted = false;
    hid.plug(device);
    const std::vector<DeviceDescription> list = listedHid(hid);
    ASSERT_EQ(list.size(), 1U);
    EXPECT_FALSE(list[0].usable());
    EXPECT_NE(list[0].obstacle.find("70-asperity-hid.rules"), std::string::npos);
    EXPECT_EQ(list[0].driver, &spaceMouseDriver());
}

/// The value that a rule asks of a key; empty: the rule does not ask for it.
std::string askedOf(const std::string& key, const std::string& rule) {
    const std::string opening = key + "==\"";
    const std::size_t begin = rule.find(opening);
    if (begin == std::string::npos) {
        return "";
    }
    const std::size_t value = begin + opening.size();
    return rule.substr(value, rule.find('"', value) - value);
}

/// Devices that the shipped rules let the operator at the screen open: vendor id and pattern for
/// product ids.
std::vector<std::pair<std::string, std::string>> shippedRules() {
    std::ifstream file(test::dataFolder() / "udev/70-asperity-hid.rules");
    std::vector<std::pair<std::string, std::string>> rules;
    for (std::string line; std::getline(file, line);) {
        if (askedOf("KERNEL", line) == "hidraw*" &&
            line.find("TAG+=\"uaccess\"") != std::string::npos) {
            rules.emplace_back(askedOf("ATTRS{idVendor}", line), askedOf("ATTRS{idProduct}", line));
        }
    }
    return rules;
}

/// udev's patterns are those of the shell, with alternatives.
bool udevMatches(const std::string& pattern, unsigned product) {
    std::ostringstream id;
    id << std::hex << std::setw(4) << std::setfill('0') << product;
    return fnmatch(("@(" + pattern + ")").c_str(), id.str().c_str(), FNM_EXTMATCH) == 0;
}

TEST(DeviceRegistry, TheUdevRulesOpenKnownDevicesAndNothingElse) {
    const auto rules = shippedRules();
    ASSERT_EQ(rules.size(), 4U);
    for (const auto& [vendor, pattern] : rules) {
        const auto vendorId = static_cast<std::uint16_t>(std::stoul(vendor, nullptr, 16));
        for (unsigned product = 0; product <= 0xFFFF; ++product) {
            const auto productId = static_cast<std::uint16_t>(product);
            const HidDeviceInfo device = withIds(vendorId, productId);
            ASSERT_EQ(udevMatches(pattern, product),
                      isSpaceMouse(device) || isWoodenHaptics(device))
                << vendor << ':' << std::hex << product;
        }
    }
}

}  // namespace
}  // namespace asperity::test
