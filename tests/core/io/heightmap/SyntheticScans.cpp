#include "tests/core/io/heightmap/SyntheticScans.h"

#include "core/io/ByteReader.h"

namespace asperity::test {

namespace {

constexpr std::size_t kDataOffset = 1200;
constexpr char kPadding = '\x1A';

std::string begin(const std::string& name, char type) { return name + '\0' + type; }

}  // namespace

std::string nanoscopeFile(const NanoscopeText& text, const std::vector<std::int32_t>& counts) {
    std::string bytes =
        "\\*File list\r\n\\Version: " + text.version +
        "\r\n\\Data length: " + std::to_string(kDataOffset) +
        "\r\n\\*Scanner list\r\n\\@Sens. Zscan: V 10.00000 nm/V\r\n"
        "\\*Ciao scan list\r\n" +
        text.scanList + text.scanGrid + "\\*Ciao image list\r\n\\Data offset: " +
        (text.dataOffset.empty() ? std::to_string(kDataOffset) : text.dataOffset) +
        "\r\n\\Data length: " + text.dataLength + "\r\n\\Bytes/pixel: " + text.bytesPerPixel +
        "\r\n\\Samps/line: " + text.samples + "\r\n\\Number of lines: " + text.lines +
        "\r\n\\Aspect Ratio: " + text.aspectRatio + "\r\n\\Scan Size: " + text.scanSize +
        "\r\n\\Line Direction: Retrace\r\n\\@2:Image Data: " + text.imageData +
        "\r\n\\@2:Z scale: " + text.zScale + "\r\n" + text.extra + "\\*File list end\r\n";
    bytes.append(kDataOffset - bytes.size(), kPadding);
    const bool wide = std::stoul(text.version, nullptr, 16) >= 0x09200000UL;
    for (const std::int32_t count : counts) {
        if (wide) {
            appendLittleEndian(bytes, count);
        } else {
            appendLittleEndian(bytes, static_cast<std::int16_t>(count));
        }
    }
    return bytes;
}

std::string gwyObjectBytes(const std::string& className, const std::string& components) {
    std::string bytes = className + '\0';
    appendLittleEndian(bytes, static_cast<std::uint32_t>(components.size()));
    return bytes + components;
}

std::string gwyInteger(const std::string& name, std::int32_t value) {
    std::string bytes = begin(name, 'i');
    appendLittleEndian(bytes, value);
    return bytes;
}

std::string gwyNumber(const std::string& name, double value) {
    std::string bytes = begin(name, 'd');
    appendLittleEndian(bytes, value);
    return bytes;
}

std::string gwyText(const std::string& name, const std::string& value) {
    return begin(name, 's') + value + '\0';
}

std::string gwyNumbers(const std::string& name, const std::vector<double>& values) {
    std::string bytes = begin(name, 'D');
    appendLittleEndian(bytes, static_cast<std::uint32_t>(values.size()));
    for (const double value : values) {
        appendLittleEndian(bytes, value);
    }
    return bytes;
}

std::string gwyComponent(const std::string& name, const std::string& object) {
    return begin(name, 'o') + object;
}

std::string gwyUnit(const std::string& name, const std::string& unit) {
    return gwyComponent(name, gwyObjectBytes("GwySIUnit", gwyText("unitstr", unit)));
}

std::string smallGwyField() {
    return gwyObjectBytes("GwyDataField",
                          gwyInteger("xres", 2) + gwyInteger("yres", 3) + gwyNumber("xreal", 4e-9) +
                              gwyNumber("yreal", 9e-9) + gwyUnit("si_unit_xy", "m") +
                              gwyUnit("si_unit_z", "m") +
                              gwyNumbers("data", {1e-9, 2e-9, 3e-9, 4e-9, 5e-9, 6e-9}));
}

std::string gwyFile(const std::string& components) {
    return "GWYP" + gwyObjectBytes("GwyContainer", components);
}

}  // namespace asperity::test
