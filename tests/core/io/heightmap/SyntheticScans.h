#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace asperity::test {

/// Text of a small NanoScope file of one 3 x 2 image; tests change single lines.
struct NanoscopeText {
    std::string version = "0x09010201";
    std::string scanList = "\\Scan Size: 20 nm\r\n\\Lines: 2\r\n\\X Offset: 7 nm\r\n"
                           "\\@Sens. ZsensSens: V 100.0000 nm/V\r\n";
    std::string samples = "3";
    std::string lines = "2";
    std::string scanSize = "30 20 nm";
    std::string bytesPerPixel = "2";
    std::string dataOffset;  ///< empty: where the samples are
    std::string dataLength = "12";
    std::string aspectRatio = "3:2";
    std::string zScale = "V [Sens. ZsensSens] (0.123 V/LSB) 2.000000 V";
    std::string imageData = "S [ZSensor] \"Height Sensor\"";
    std::string extra;
    std::string scanGrid;  ///< further lines of the scan list
};

/// The bytes of such a file; the counts are stored as 16 or 32 bits by the version.
[[nodiscard]] std::string nanoscopeFile(const NanoscopeText& text,
                                        const std::vector<std::int32_t>& counts = {1, 2, 3, 4, 5,
                                                                                   6});

/// Pieces of a serialized Gwyddion object.
[[nodiscard]] std::string gwyObjectBytes(const std::string& className,
                                         const std::string& components);
[[nodiscard]] std::string gwyInteger(const std::string& name, std::int32_t value);
[[nodiscard]] std::string gwyNumber(const std::string& name, double value);
[[nodiscard]] std::string gwyText(const std::string& name, const std::string& value);
[[nodiscard]] std::string gwyNumbers(const std::string& name, const std::vector<double>& values);
[[nodiscard]] std::string gwyUnit(const std::string& name, const std::string& unit);
/// A component of type 'o'. @param object from gwyObjectBytes
[[nodiscard]] std::string gwyComponent(const std::string& name, const std::string& object);
/// A data field of 2 columns x 3 rows, 4 nm x 9 nm, with heights of 1 to 6 nm.
[[nodiscard]] std::string smallGwyField();
/// A whole file. @param components of the container
[[nodiscard]] std::string gwyFile(const std::string& components);

}  // namespace asperity::test
