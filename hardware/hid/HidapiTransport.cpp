#include "hardware/hid/HidapiTransport.h"

#include "core/Error.h"
#include "core/words/DeviceWords.h"

#include <hidapi.h>

#include <cerrno>
#include <fcntl.h>
#include <linux/hidraw.h>
#include <mutex>
#include <sys/ioctl.h>
#include <system_error>
#include <unistd.h>

namespace asperity {

/// hidapi while anybody needs it. What it keeps for the whole process, such as the text of the last
/// error, is not guarded: all that touches it holds the mutex.
class HidapiTransport::Library {
public:
    Library() {
        const std::lock_guard lock(mutex());
        if (hid_init() != 0) {
            throw Error("hidapi could not be made ready for HID devices");
        }
    }
    ~Library() {
        const std::lock_guard lock(mutex());
        hid_exit();
    }
    Library(const Library&) = delete;
    Library& operator=(const Library&) = delete;

    static std::mutex& mutex() {
        static std::mutex instance;
        return instance;
    }

    /// The one that the process has, made when there is none.
    static std::shared_ptr<Library> shared() {
        static std::mutex making;
        static std::weak_ptr<Library> current;
        const std::lock_guard lock(making);
        std::shared_ptr<Library> library = current.lock();
        if (!library) {
            library = std::make_shared<Library>();
            current = library;
        }
        return library;
    }
};

class HidapiTransport::Connection final : public HidConnection {
public:
    Connection(std::shared_ptr<Library> library, hid_device* device)
        : library_(std::move(library)), device_(device) {}
    ~Connection() override {
        const std::lock_guard lock(Library::mutex());
        hid_close(device_);
    }
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;

    std::optional<std::size_t> read(std::span<std::uint8_t> report,
                                    std::chrono::milliseconds patience) override {
        const int count = hid_read_timeout(device_, report.data(), report.size(),
                                           static_cast<int>(patience.count()));
        if (count < 0) {
            return std::nullopt;
        }
        return static_cast<std::size_t>(count);
    }

    bool write(std::span<const std::uint8_t> report) override {
        return hid_write(device_, report.data(), report.size()) >= 0;
    }

private:
    std::shared_ptr<Library> library_;
    hid_device* device_;
};

namespace {

class FileHandle {
public:
    explicit FileHandle(const std::string& path)
        : descriptor_(::open(path.c_str(), O_RDWR | O_CLOEXEC | O_NONBLOCK | O_NOCTTY)) {}
    ~FileHandle() {
        if (descriptor_ >= 0) {
            ::close(descriptor_);
        }
    }
    FileHandle(const FileHandle&) = delete;
    FileHandle& operator=(const FileHandle&) = delete;
    [[nodiscard]] int descriptor() const { return descriptor_; }

private:
    int descriptor_;
};

[[noreturn]] void refuse(const std::string& path, int code) {
    if (code == EACCES || code == EPERM) {
        throw Error(path + ": " + kNoPermission);
    }
    throw Error(path + ": the device cannot be opened: " + std::generic_category().message(code));
}

/// hidapi 0.13 uses freed memory when it opens what is no hidraw node: ask the kernel first.
void requireHidrawNode(const std::string& path) {
    const FileHandle node(path);
    if (node.descriptor() < 0) {
        refuse(path, errno);
    }
    int descriptorSize = 0;
    if (::ioctl(node.descriptor(), HIDIOCGRDESCSIZE, &descriptorSize) < 0) {
        throw Error(path + ": not a hidraw device, or it has just been unplugged");
    }
}

/// The system's wide characters are Unicode code points.
void appendUtf8(std::string& text, char32_t point) {
    const auto tail = [&](int shift) {
        text += static_cast<char>(0x80U | ((point >> static_cast<unsigned>(shift)) & 0x3FU));
    };
    if (point < 0x80U) {
        text += static_cast<char>(point);
    } else if (point < 0x800U) {
        text += static_cast<char>(0xC0U | (point >> 6U));
        tail(0);
    } else if (point < 0x10000U) {
        text += static_cast<char>(0xE0U | (point >> 12U));
        tail(6);
        tail(0);
    } else {
        text += static_cast<char>(0xF0U | (point >> 18U));
        tail(12);
        tail(6);
        tail(0);
    }
}

std::string toUtf8(const wchar_t* wide) {
    std::string text;
    for (; wide != nullptr && *wide != L'\0'; ++wide) {
        appendUtf8(text, static_cast<char32_t>(*wide));
    }
    return text;
}

HidDeviceInfo infoOf(const hid_device_info& entry) {
    return {.path = entry.path,
            .vendorId = entry.vendor_id,
            .productId = entry.product_id,
            .manufacturer = toUtf8(entry.manufacturer_string),
            .product = toUtf8(entry.product_string),
            .serial = toUtf8(entry.serial_number),
            .permitted = ::access(entry.path, R_OK | W_OK) == 0};
}

}  // namespace

HidapiTransport::HidapiTransport() : library_(Library::shared()) {}

// hidapi lists a device once for each of its collections, one after the other.
std::vector<HidDeviceInfo> HidapiTransport::enumerate() {
    const std::lock_guard lock(Library::mutex());
    const std::unique_ptr<hid_device_info, decltype(&hid_free_enumeration)> list(
        hid_enumerate(0, 0), &hid_free_enumeration);
    std::vector<HidDeviceInfo> devices;
    for (const hid_device_info* entry = list.get(); entry != nullptr; entry = entry->next) {
        if (entry->path == nullptr) {
            continue;
        }
        if (devices.empty() || devices.back().path != entry->path) {
            devices.push_back(infoOf(*entry));
        }
        devices.back().usages.push_back({.page = entry->usage_page, .id = entry->usage});
    }
    return devices;
}

std::unique_ptr<HidConnection> HidapiTransport::open(const std::string& path) {
    requireHidrawNode(path);
    const std::lock_guard lock(Library::mutex());
    hid_device* device = hid_open_path(path.c_str());
    if (device == nullptr) {
        throw Error(path + ": the device cannot be opened: " + toUtf8(hid_error(nullptr)));
    }
    return std::make_unique<Connection>(library_, device);
}

std::vector<ListedDevice> listHid(const DeviceSite& site, HidKind isOfKind) {
    std::vector<ListedDevice> list;
    for (const HidDeviceInfo& device : site.hid().enumerate()) {
        if (isOfKind(device)) {
            list.push_back({.name = device.name(),
                            .path = device.path,
                            .vendorId = device.vendorId,
                            .productId = device.productId,
                            .obstacle = device.permitted ? "" : kNoPermission});
        }
    }
    return list;
}

}  // namespace asperity
