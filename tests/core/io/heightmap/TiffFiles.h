#pragma once

#include "core/io/heightmap/SampleRows.h"

#include <cstdint>
#include <string>
#include <vector>

namespace asperity::test {

/// A field of a TIFF directory: numbers of its type, or bytes.
struct TiffTestField {
    std::uint16_t tag = 0;
    std::uint16_t type = 3;
    std::vector<double> numbers;
    std::string bytes;  ///< instead of numbers, for types of one byte a value
};
[[nodiscard]] TiffTestField tiffText(std::uint16_t tag, const std::string& text);
[[nodiscard]] TiffTestField tiffDouble(std::uint16_t tag, double value);
[[nodiscard]] TiffTestField tiffInteger(std::uint16_t tag, double value);

/// An uncompressed image of 3 x 4 pixels in two strips; tests change single values.
struct TiffTestImage {
    SampleType type = SampleType::UInt16;
    int columns = 3;
    int rows = 4;
    int rowsPerStrip = 2;
    int samplesPerPixel = 1;
    int photometric = 1;
    std::vector<double> values = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
    bool lastStripFirst = false;       ///< strips lie in the file from the last one on
    std::vector<TiffTestField> extra;  ///< replaces a field of the same tag
};

/// The bytes of a TIFF file of these images.
[[nodiscard]] std::string tiffFile(const std::vector<TiffTestImage>& images,
                                   ByteOrder order = ByteOrder::Little, bool big = false);

/// Samples as they are stored.
[[nodiscard]] std::string sampleBytes(const std::vector<double>& values, SampleType type,
                                      ByteOrder order);

}  // namespace asperity::test
