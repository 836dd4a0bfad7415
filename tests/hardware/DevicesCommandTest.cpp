#include "app/commands/Commands.h"
#include "tests/hardware/VirtualSpaceMouse.h"

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <nlohmann/json.hpp>

namespace asperity::test {
namespace {

/// Returns the standard output of `asperity` for these words.
std::string printed(const std::string& words) {
    CLI::App program;
    addDevicesCommand(program);
    testing::internal::CaptureStdout();
    program.parse(words);
    return testing::internal::GetCapturedStdout();
}

nlohmann::json deviceNamed(const std::string& name) {
    const nlohmann::json devices = nlohmann::json::parse(printed("devices --json")).at("devices");
    const auto found = std::find_if(devices.begin(), devices.end(), [&name](const auto& device) {
        return device.at("name") == name;
    });
    return found == devices.end() ? nlohmann::json() : *found;
}

TEST(DevicesCommand, ListsMouseAndKeyboardFirst) {
    const VirtualSpaceMouse device;
    const nlohmann::json first =
        nlohmann::json::parse(printed("devices --json")).at("devices").at(0);
    EXPECT_EQ(first.at("name"), "mouse and keyboard");
    EXPECT_EQ(first.at("usable"), true);
    EXPECT_EQ(first.at("path"), nullptr);
}

TEST(DevicesCommand, ListsTheSimulatedDevice) {
    const VirtualSpaceMouse device;
    EXPECT_EQ(deviceNamed("simulated device"), nlohmann::json::parse(R"({
        "name": "simulated device", "vendor_id": null, "product_id": null, "path": null,
        "driver": "simulated", "senses": ["x", "y", "z"],
        "renders_force": true, "usable": true, "obstacle": null})"));
}

TEST(DevicesCommand, SaysWhatTheSpaceMouseCanDo) {
    const VirtualSpaceMouse device;
    EXPECT_EQ(deviceNamed("SpaceMouse Compact"), nlohmann::json::parse(R"({
        "name": "SpaceMouse Compact", "vendor_id": "256f", "product_id": "c635",
        "path": "/dev/hidraw7", "driver": "SpaceMouse",
        "senses": ["x", "y", "z", "rx", "ry", "rz", "buttons"],
        "renders_force": false, "usable": true, "obstacle": null})"));
}

TEST(DevicesCommand, SaysThatAWoodenHapticsRendersForce) {
    const VirtualHid device(
        {.vendorId = 0x16c0,
         .productId = 0x0486,
         .manufacturer = "Teensyduino",
         .product = "WoodenHaptics",
         .reportDescriptor = {0x06, 0xAB, 0xFF, 0x0A, 0x00, 0x02, 0xA1, 0x01, 0xC0}});
    EXPECT_EQ(deviceNamed("WoodenHaptics"), nlohmann::json::parse(R"({
        "name": "WoodenHaptics", "vendor_id": "16c0", "product_id": "0486",
        "path": "/dev/hidraw7", "driver": "WoodenHaptics",
        "senses": ["x", "y", "z", "buttons"],
        "renders_force": true, "usable": true, "obstacle": null})"));
}

TEST(DevicesCommand, SaysWhyAnUnknownDeviceCannotBeUsed) {
    const VirtualSpaceMouse device;
    const nlohmann::json unknown = deviceNamed("Acme Maus");
    EXPECT_EQ(unknown.at("driver"), nullptr);
    EXPECT_EQ(unknown.at("usable"), false);
    EXPECT_EQ(unknown.at("obstacle"), "no driver for this device");
}

TEST(DevicesCommand, PrintsALineForEachDeviceForPeople) {
    const VirtualSpaceMouse device;
    const std::string text = printed("devices");
    EXPECT_NE(text.find("mouse and keyboard\n  usable\n"), std::string::npos) << text;
    EXPECT_NE(text.find("SpaceMouse Compact, 256f:c635, /dev/hidraw7\n  usable\n"),
              std::string::npos)
        << text;
    EXPECT_NE(text.find("not usable: no driver for this device"), std::string::npos) << text;
    EXPECT_EQ(text.find("No HID device"), std::string::npos) << text;
}

TEST(DevicesCommand, SaysWhenNoHidDeviceIsThere) {
    const std::unique_ptr<UMockdevTestbed, decltype(&g_object_unref)> empty(umockdev_testbed_new(),
                                                                            &g_object_unref);
    EXPECT_NE(printed("devices").find("No HID device is plugged in.\n"), std::string::npos);
    EXPECT_EQ(nlohmann::json::parse(printed("devices --json")).at("devices").size(), 2U)
        << "mouse and keyboard, simulated device";
}

}  // namespace
}  // namespace asperity::test
