#include "app/commands/ConvertCurve.h"

#include "app/commands/CurveReport.h"
#include "core/SiFormat.h"
#include "core/io/curves/CurveSegments.h"
#include "core/io/curves/ForceCurveFile.h"
#include "core/io/tables/CsvWriter.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>

namespace asperity {

namespace {

struct CurveTableColumn {
    const char* title;
    std::vector<double> CurveSegment::*values;
};

using CurveTableColumns = std::vector<CurveTableColumn>;

/// Those of `csv` tables of measured curves; separation and signal where the curve has nothing
/// else.
CurveTableColumns columnsOf(const MeasuredForceCurve& curve) {
    const auto has = [&curve](std::vector<double> CurveSegment::*array) {
        return std::ranges::any_of(curve.segments, [array](const CurveSegment& segment) {
            return !(segment.*array).empty();
        });
    };
    CurveTableColumns columns = {{"time_s", &CurveSegment::time}};
    columns.push_back(has(&CurveSegment::base)
                          ? CurveTableColumn{"base_m", &CurveSegment::base}
                          : CurveTableColumn{"separation_m", &CurveSegment::separation});
    if (has(&CurveSegment::deflection) || has(&CurveSegment::force)) {
        columns.push_back({"deflection_m", &CurveSegment::deflection});
        columns.push_back({"force_N", &CurveSegment::force});
    } else {
        columns.push_back({"signal_V", &CurveSegment::signal});
    }
    return columns;
}

std::string factText(const char* name, double value, const char* unit) {
    return std::string(name) + ": " + (value > 0.0 ? formatSi(value, unit) : "not in the file");
}

std::vector<std::string> commentsOf(const ConvertedFile& file, std::size_t index,
                                    const CurveContents& contents) {
    std::vector<std::string> comments = {
        "curve " + std::to_string(index) + " of " +
            std::filesystem::path(file.input).filename().string(),
        "base_m grows towards the sample; as stored, no baseline is taken off",
        factText("spring constant", contents.curve.stiffness, "N/m"),
        factText("optical sensitivity", contents.curve.invols, "m/V")};
    if (!contents.heightChannel.empty()) {
        comments.push_back("height channel: " + contents.heightChannel);
    }
    return comments;
}

void writeCurve(const ConvertedFile& file, std::size_t index, const CurveContents& contents) {
    const CurveTableColumns columns = columnsOf(contents.curve);
    std::vector<std::string> titles = {"segment"};
    for (const CurveTableColumn& column : columns) {
        titles.emplace_back(column.title);
    }
    CsvWriter writer(file.output, commentsOf(file, index, contents), titles);
    for (std::size_t number = 0; number < contents.curve.segments.size(); ++number) {
        const CurveSegment& segment = contents.curve.segments[number];
        const std::string name = std::to_string(number) + ":" + nameOf(segment.kind);
        for (std::size_t i = 0; i < loadOf(segment).size(); ++i) {
            writer.add(name);
            for (const CurveTableColumn& column : columns) {
                const std::vector<double>& values = segment.*column.values;
                if (values.empty()) {
                    writer.add(std::string_view());
                } else {
                    writer.add(values[i]);
                }
            }
            writer.endRow();
        }
    }
    writer.close();
}

}  // namespace

bool isCurveTable(const std::string& file) {
    return std::filesystem::path(file).extension() == ".csv";
}

void requireCurveOptions(const ConvertOptions& options) {
    const bool isForMaps = !options.channel.empty() || options.all || options.bits != 0 ||
                           options.residual || options.tipRadius > 0.0;
    if (isForMaps) {
        throw CLI::ValidationError("OUT", "a .csv is the table of a force curve: options for "
                                          "height maps do not apply to it");
    }
}

Converted convertCurve(const ConvertOptions& options, const ConvertedFile& file) {
    const ForceCurveFile curves(file.input, options.curves.read);
    const std::size_t index = options.curves.index.value_or(0);
    const CurveContents contents = curves.contents(index);
    writeCurve(file, index, contents);
    std::size_t points = 0;
    for (const CurveSegment& segment : contents.curve.segments) {
        points += loadOf(segment).size();
    }
    Converted converted{.summary = "curve " + std::to_string(index) + " of " +
                                   std::to_string(curves.count()) + ", " + std::to_string(points) +
                                   " points",
                        .notes = contents.notes};
    for (const std::string& missing : missingIn(contents.curve)) {
        converted.notes.push_back("the file does not give its " + missing);
    }
    return converted;
}

}  // namespace asperity
