#include "app/commands/Commands.h"
#include "app/program/JsonText.h"
#include "core/PrintableText.h"
#include "hardware/DeviceRegistry.h"
#include "hardware/hid/HidapiTransport.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iomanip>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

namespace asperity {

namespace {

std::string hexadecimal(std::uint16_t id) {
    std::ostringstream text;
    text << std::hex << std::setw(4) << std::setfill('0') << id;
    return text.str();
}

nlohmann::json textOrNull(const std::string& text) {
    return text.empty() ? nlohmann::json() : nlohmann::json(text);
}

/// A property that a device lacks is null: the mouse has no path, an unknown device no driver.
nlohmann::json deviceJson(const DeviceDescription& device) {
    const bool hid = !device.path.empty();
    const DeviceDriver* const driver = device.driver;
    return {{"name", device.name},
            {"vendor_id", hid ? nlohmann::json(hexadecimal(device.vendorId)) : nlohmann::json()},
            {"product_id", hid ? nlohmann::json(hexadecimal(device.productId)) : nlohmann::json()},
            {"path", textOrNull(device.path)},
            {"driver", textOrNull(driver != nullptr ? driver->key : "")},
            {"senses", driver != nullptr ? driver->senses : std::vector<std::string>()},
            {"renders_force", driver != nullptr && driver->rendersForce},
            {"usable", device.usable()},
            {"obstacle", textOrNull(device.obstacle)}};
}

void printJson(const std::vector<DeviceDescription>& devices) {
    nlohmann::json list = nlohmann::json::array();
    for (const DeviceDescription& device : devices) {
        list.push_back(deviceJson(device));
    }
    const nlohmann::json report = {{"devices", list}};
    std::cout << jsonText(report) << '\n';
}

void printDevice(const DeviceDescription& device) {
    std::cout << printable(device.name);
    if (!device.path.empty()) {
        std::cout << ", " << hexadecimal(device.vendorId) << ':' << hexadecimal(device.productId)
                  << ", " << printable(device.path);
    }
    std::cout << "\n  " << (device.usable() ? "usable" : "not usable: " + device.obstacle) << '\n';
    if (device.driver == nullptr) {
        return;
    }
    std::cout << "  driver: " << device.driver->key << "\n  senses:";
    for (const std::string& sense : device.driver->senses) {
        std::cout << ' ' << sense;
    }
    std::cout << "\n  renders force: " << (device.driver->rendersForce ? "yes" : "no") << '\n';
}

void printForPeople(const std::vector<DeviceDescription>& devices) {
    for (const DeviceDescription& device : devices) {
        printDevice(device);
    }
    const auto isHid = [](const DeviceDescription& device) { return !device.path.empty(); };
    if (std::ranges::none_of(devices, isHid)) {
        std::cout << "No HID device is plugged in.\n";
    }
}

}  // namespace

void addDevicesCommand(CLI::App& program) {
    auto json = std::make_shared<bool>(false);
    CLI::App* command = program.add_subcommand(
        "devices", "List input devices: mouse, keyboard, HID and force-feedback devices");
    command->add_flag("--json", *json, "print JSON");
    command->callback([json] {
        HidapiTransport transport;
        const std::vector<DeviceDescription> devices =
            listDevices({.hid = [&transport]() -> HidTransport& { return transport; }});
        if (*json) {
            printJson(devices);
        } else {
            printForPeople(devices);
        }
    });
}

}  // namespace asperity
