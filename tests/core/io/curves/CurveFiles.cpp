#include "tests/core/io/curves/CurveFiles.h"

#include "core/io/ByteReader.h"
#include "tests/core/io/heightmap/ZipFiles.h"

#include <algorithm>

namespace asperity::test {

namespace {

std::string bigEndianText(const std::vector<std::int16_t>& samples) {
    std::string bytes;
    for (const std::int16_t sample : samples) {
        std::string one;
        appendLittleEndian(one, sample);
        std::ranges::reverse(one);
        bytes += one;
    }
    return bytes;
}

/// Metres or volts with their slots, as JPK's program writes them.
std::map<std::string, std::string> usualShared() {
    const std::string height = "lcd-info.0.";
    const std::string lever = "lcd-info.1.";
    std::map<std::string, std::string> shared = {
        {height + "type", "integer-data"},
        {height + "conversion-set.conversions.list", "nominal"},
        {height + "conversion-set.conversions.default", "nominal"},
        {height + "conversion-set.conversions.base", "absolute"},
        {height + "conversion-set.conversion.absolute.defined", "false"},
        {lever + "type", "integer-data"},
        {lever + "conversion-set.conversions.list", "distance force"},
        {lever + "conversion-set.conversions.default", "force"},
        {lever + "conversion-set.conversions.base", "volts"},
        {lever + "conversion-set.conversion.volts.defined", "false"}};
    const auto scaling = [&shared](const std::string& path, const std::string& multiplier,
                                   const std::string& offset, const std::string& unit) {
        shared[path + ".scaling.style"] = "offsetmultiplier";
        shared[path + ".scaling.multiplier"] = multiplier;
        shared[path + ".scaling.offset"] = offset;
        shared[path + ".scaling.unit.unit"] = unit;
    };
    const auto slot = [&](const std::string& path, const std::string& parent,
                          const std::string& multiplier, const std::string& offset,
                          const std::string& unit) {
        shared[path + ".defined"] = "true";
        shared[path + ".base-calibration-slot"] = parent;
        scaling(path, multiplier, offset, unit);
    };
    shared[height + "encoder.type"] = "signedshort";
    scaling(height + "encoder", "1e-9", "0", "m");
    shared[lever + "encoder.type"] = "signedshort-limited";
    scaling(lever + "encoder", "0.01", "0", "V");
    slot(height + "conversion-set.conversion.nominal", "absolute", "1.0", "1e-6", "m");
    slot(lever + "conversion-set.conversion.distance", "volts", "5e-8", "0", "m");
    slot(lever + "conversion-set.conversion.force", "distance", "0.1", "0", "N");
    return shared;
}

std::string propertiesText(const std::map<std::string, std::string>& entries) {
    std::string text = "#Thu May 21 19:53:44 CEST 2015\r\n";
    for (const auto& [key, value] : entries) {
        text += key + "=" + value + "\r\n";
    }
    return text;
}

std::string segmentHeader(const JpkSegmentText& segment) {
    return "force-segment-header.settings.segment-settings.style=" + segment.style +
           "\nforce-segment-header.duration=" + segment.duration +
           "\nforce-segment-header.num-points=" + segment.points +
           "\nforce-segment-header.time-stamp=2015-05-21 18\\:33\\:25.619 +0200"
           "\nchannels.list=height vDeflection"
           "\nchannel.height.lcd-info.*=0\nchannel.height.data.file.name=channels/height.dat"
           "\nchannel.vDeflection.lcd-info.*=1"
           "\nchannel.vDeflection.data.file.name=channels/vDeflection.dat\n";
}

void replaceAll(std::string& text, const std::string& mark, const std::string& value) {
    for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark)) {
        text.replace(at, mark.size(), value);
    }
}

}  // namespace

std::string jpkCurveFile(const JpkCurveText& text) {
    std::vector<ZippedFile> files = {
        {"header.properties", "type=force-scan-map\nforce-scan-map.position-pattern."
                              "back-and-forth=true\nforce-scan-map.position-pattern.grid.ilength=2"
                              "\nforce-scan-map.position-pattern.grid.jlength=8\n"}};
    for (const auto& [folder, segments] : text.curves) {
        for (std::size_t i = segments.size(); i-- > 0;) {  // in no order
            const std::string path = folder + "segments/" + std::to_string(i) + "/";
            files.push_back({path + "channels/height.dat", bigEndianText(segments[i].height)});
            if (segments[i].hasDeflectionFile) {
                files.push_back(
                    {path + "channels/vDeflection.dat", bigEndianText(segments[i].deflection)});
            }
            files.push_back({path + "segment-header.properties", segmentHeader(segments[i])});
        }
    }
    std::map<std::string, std::string> shared = usualShared();
    for (const auto& [key, value] : text.shared) {
        shared[key] = value;
    }
    files.push_back({"shared-data/header.properties", propertiesText(shared)});
    return zipFile(files);
}

std::vector<JpkSegmentText> jpkCycle() {
    JpkSegmentText retract;
    retract.style = "retract";
    retract.height = {100, 200, 300, 400};
    retract.deflection = {10, 4, -2, 0};
    return {JpkSegmentText{}, retract};
}

std::string nanoscopeCurveFile(const NanoscopeCurveText& text) {
    std::string data;
    for (const std::int32_t sample : text.samples) {
        if (text.width == 2) {
            appendLittleEndian(data, static_cast<std::int16_t>(sample));
        } else {
            appendLittleEndian(data, sample);
        }
    }
    const int length = text.dataLength > 0 ? text.dataLength : static_cast<int>(data.size());
    std::string header =
        "\\*Force file list\r\n\\Version: " + text.version +
        "\r\n\\Start context: " + text.context +
        "\r\n\\*Scanner list\r\n\\@Sens. Zsens: V 10.0 nm/V\r\n\\*Ciao scan list\r\n"
        "\\Scan Size: 2000 nm\r\n\\@Sens. DeflSens: V 30.00000\r\n\\*Ciao force list\r\n"
        "\\Forward vel.: 10\r\n\\Reverse vel.: 20\r\n\\force/line: " +
        std::to_string(text.perLine) +
        "\r\n\\@4:Ramp Size Zsweep: V [Sens. Zsens] (\\Data length V/LSB) 40.0 V\r\n"
        "\\*Ciao force image list\r\n\\Data offset: 1000\r\n\\Data length: " +
        std::to_string(length) + "\r\n\\Bytes/pixel: 2\r\n\\Samps/line: " + text.counts +
        "\r\n\\Spring Constant: 0.2\r\n\\@4:Image Data: S [DeflectionError] \"Deflection "
        "Error\"\r\n"
        "\\@4:Z scale: " +
        text.zScale + "\r\n\\@4:Ramp Size: " + text.rampSize + "\r\n\\*File list end\r\n\x1A";
    replaceAll(header, "\n\n", "\n");
    header.resize(1000, '\0');
    return header + data;
}

}  // namespace asperity::test
