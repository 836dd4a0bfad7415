#pragma once

#include "core/io/heightmap/SampleRows.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace asperity::test {

/// Numbers as the samples of a file.
[[nodiscard]] std::string samples(SampleType type, ByteOrder order,
                                  const std::vector<double>& numbers);

/// An Igor binary wave of version 5; by default 3 x 2 heights without labels.
struct IgorWaveText {
    ByteOrder order = ByteOrder::Little;
    int version = 5;
    int type = 2;  ///< its code in the file: 2 is float32
    SampleType stored = SampleType::Float32;
    std::array<std::int32_t, 4> counts{3, 2, 0, 0};
    std::array<double, 4> steps{1e-9, 2e-9, 1.0, 1.0};
    std::string unit = "m";
    std::string dimensionUnit = "m";
    std::string note = "ScanSize: 3e-09\rScanAngle: 30\xB0\rScanAngle: 40\r";
    std::vector<std::string> columnLabels;  ///< of dimension 1; the first is its own
    std::vector<std::string> layerLabels;   ///< of dimension 2; the first is its own
    std::string footer;
    std::vector<double> numbers{1, 2, 3, 4, 5, 6};
    int numberOfNumbers = -1;  ///< -1: as many as there are
};
[[nodiscard]] std::string igorFile(const IgorWaveText& wave);

/// A Nanonis file of images of 3 x 2 pixels, 30 nm x 20 nm.
struct NanonisText {
    std::string version = "2";
    std::string type = "FLOAT            MSBFIRST";
    std::string time = "131.3";
    std::string pixels = "3       2";
    std::string range = "3.0E-8           2.0E-8";
    std::string direction = "down";
    std::string table = "\tChannel\tName\tUnit\tDirection\tCalibration\tOffset\n"
                        "\t14\tZ\tm\tboth\t1.764E-8\t0.000E+0\n";
    std::string comment = "first line\nsecond line";
    std::string mark = "\x1A\x04";
};
[[nodiscard]] std::string nanonisFile(const NanonisText& text,
                                      const std::vector<double>& numbers = {1, 2, 3, 4, 5, 6, 7, 8,
                                                                            9, 10, 11, 12});

/// A channel of a Nanosurf file; by default an image of 3 x 2 pixels, 30 nm x 20 nm.
struct NanosurfChannel {
    std::string frame = "Scan forward";
    std::string name = "Topography";
    std::string unit = "m";
    std::string points = "3";
    std::string lines = "2";
    std::string bits = "16";
    std::string minimum = "-1e-06";
    std::string range = "2e-06";
    std::string sizeX = "3e-08";
    std::string order = "Intel";
    SampleType stored = SampleType::Int16;
    std::vector<double> numbers{-32768, 0, 1, 2, 3, 32767};
};
/// Each channel is the group of its own.
[[nodiscard]] std::string nanosurfFile(const std::vector<NanosurfChannel>& channels);

/// A PicoView file of 3 x 2 pixels, 30 nm x 20 nm, with one image.
struct PicoviewText {
    std::string firstLine = "fileType      Image\n";
    std::string size = "xLength       3.0e-008\nyLength       2.0e-008\n";
    std::string image = "bufferLabel   Topography\nbufferRange   2.0e+000\nbufferUnit    um\n"
                        "trace         Trace\n";
    std::string data = "BINARY_32";
};
[[nodiscard]] std::string picoviewFile(const PicoviewText& text, SampleType stored,
                                       const std::vector<double>& numbers = {1, 2, 3, 4, 5, 6});

/// A WSxM file of 3 x 2 pixels, 30 nm x 20 nm.
struct WsxmText {
    std::string kind = "SxM Image file";
    std::string typeLine = "    Image Data Type: double\r\n";
    std::string amplitudeX = "30 nm";
    std::string amplitudeZ = "10 nm";
    std::string headerSize = "17";
    SampleType stored = SampleType::Float64;
};
[[nodiscard]] std::string wsxmFile(const WsxmText& text,
                                   const std::vector<double>& numbers = {1, 2, 3, 4, 5, 6});

/// A Digital Surf file of 3 x 2 pixels, 30 nm x 20 nm, with a comment and a private zone.
struct DigitalSurfText {
    std::string magic = "DIGITAL SURF";
    int object = 2;
    int specialPoints = 0;
    int bits = 16;
    int lowest = 1;
    int inversion = 0;
    int commentSize = 5;
    int privateSize = 3;
    std::string unit = "nm";
    float offset = 0.0F;  ///< in the unit
    SampleType stored = SampleType::Int16;
    int rows = 2;
};
[[nodiscard]] std::string digitalSurfFile(const DigitalSurfText& text,
                                          const std::vector<double>& numbers = {1, 2, 3, 4, 5, 6});

}  // namespace asperity::test
