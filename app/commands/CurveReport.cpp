#include "app/commands/CurveReport.h"

#include "app/commands/TextTable.h"
#include "app/program/JsonText.h"
#include "core/Error.h"
#include "core/PrintableText.h"
#include "core/io/FileBytes.h"
#include "core/io/curves/CurveSegments.h"
#include "core/io/curves/ThermalSpectrumFile.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string_view>

namespace asperity {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kShownCurves = 8;  ///< for people, of many

/// An array of a segment, as it is called.
struct SegmentArray {
    std::vector<double> CurveSegment::*values;
    const char* name;
    const char* key;  ///< of its range
    const char* unit;
};

constexpr std::array<SegmentArray, 5> kSegmentArrays = {
    {{&CurveSegment::base, "base", "base_m", "m"},
     {&CurveSegment::separation, "separation", "separation_m", "m"},
     {&CurveSegment::signal, "signal", "signal_v", "V"},
     {&CurveSegment::deflection, "deflection", "deflection_m", "m"},
     {&CurveSegment::force, "force", "force_n", "N"}}};

/// The curves that are listed.
std::vector<std::size_t> indexesOf(const ForceCurveFile& file, const CurveFileOptions& options,
                                   std::size_t most) {
    if (options.index) {
        return {*options.index};
    }
    std::vector<std::size_t> indexes(std::min(most, file.count()));
    for (std::size_t i = 0; i < indexes.size(); ++i) {
        indexes[i] = i;
    }
    return indexes;
}

/// Null in place of what a file does not give.
Json known(double value) { return value > 0.0 ? Json(value) : Json(); }

Json segmentJson(const CurveSegment& segment) {
    Json json = {{"kind", nameOf(segment.kind)}, {"points", loadOf(segment).size()}};
    const double duration = durationOf(segment);
    json["duration_s"] = std::isnan(duration) ? Json() : Json(duration);
    for (const SegmentArray& array : kSegmentArrays) {
        const std::vector<double>& values = segment.*array.values;
        if (!values.empty()) {
            const auto [low, high] = std::ranges::minmax(values);
            json[array.key] = {low, high};
        }
    }
    return json;
}

Json contentsJson(const CurveContents& contents) {
    const MeasuredForceCurve& curve = contents.curve;
    Json json = {{"stiffness_n_m", known(curve.stiffness)},
                 {"invols_m_per_v", known(curve.invols)},
                 {"height_channel", contents.heightChannel},
                 {"height_channels", contents.heights},
                 {"missing", missingIn(curve)},
                 {"notes", contents.notes},
                 {"segments", Json::array()}};
    for (const CurveSegment& segment : curve.segments) {
        json["segments"].push_back(segmentJson(segment));
    }
    return json;
}

Json curveJson(const ForceCurveFile& file, std::size_t index) {
    Json json = {{"index", index}};
    if (const auto position = file.position(index)) {
        json["x_m"] = position->x;
        json["y_m"] = position->y;
    }
    if (const auto cell = file.cell(index)) {
        json["column"] = cell->column;
        json["row"] = cell->row;
    }
    try {
        json.update(contentsJson(file.contents(index)));
    } catch (const InputError& error) {
        json["refused"] = error.what();
    }
    return json;
}

std::string rangeText(const std::vector<double>& values, const char* unit) {
    const auto [low, high] = std::ranges::minmax(values);
    return quantityText(low, unit) + " ... " + quantityText(high, unit);
}

/// The range of what the segment's distance and its load are.
TableRow segmentRow(const CurveSegment& segment) {
    const double duration = durationOf(segment);
    TableRow row = {std::string("  ") + nameOf(segment.kind),
                    std::to_string(loadOf(segment).size()),
                    std::isnan(duration) ? "-" : quantityText(duration, "s")};
    for (const SegmentArray& array : kSegmentArrays) {
        const std::vector<double>& values = segment.*array.values;
        if (!values.empty()) {
            row.push_back(std::string(array.name) + " " + rangeText(values, array.unit));
        }
    }
    return row;
}

std::string calibrationText(const CurveContents& contents) {
    const MeasuredForceCurve& curve = contents.curve;
    const auto value = [](double number, const char* unit) {
        return number > 0.0 ? quantityText(number, unit) : std::string("not in the file");
    };
    std::string text = "  spring constant " + value(curve.stiffness, "N/m") +
                       ", optical sensitivity " + value(curve.invols, "m/V");
    if (!contents.heightChannel.empty()) {
        text += ", height channel " + contents.heightChannel;
        for (std::size_t i = 0; i < contents.heights.size(); ++i) {
            if (contents.heights[i] != contents.heightChannel) {
                text += (text.ends_with(contents.heightChannel) ? " (others: " : ", ") +
                        contents.heights[i];
            }
        }
        text += contents.heights.size() > 1 ? ")" : "";
    }
    return text;
}

void printContents(const CurveContents& contents) {
    std::vector<TableRow> rows;
    std::size_t cells = 0;
    for (const CurveSegment& segment : contents.curve.segments) {
        rows.push_back(segmentRow(segment));
        cells = std::max(cells, rows.back().size());
    }
    for (TableRow& row : rows) {
        row.resize(cells);
    }
    printTable(std::move(rows), 1);
    std::cout << printable(calibrationText(contents)) << '\n';
    const std::vector<std::string> missing = missingIn(contents.curve);
    for (std::size_t i = 0; i < missing.size(); ++i) {
        std::cout << (i == 0 ? "  missing: " : ", ") << missing[i];
    }
    std::cout << (missing.empty() ? "" : "\n");
    for (const std::string& note : contents.notes) {
        std::cout << "  - " << printable(note) << '\n';
    }
}

void printCurve(const ForceCurveFile& file, std::size_t index) {
    std::cout << "curve " << index;
    if (const auto position = file.position(index)) {
        std::cout << " at " << quantityText(position->x, "m") << ", "
                  << quantityText(position->y, "m");
    }
    std::cout << '\n';
    try {
        printContents(file.contents(index));
    } catch (const InputError& error) {
        std::cout << "  refused: " << error.what() << '\n';
    }
}

/// Empty: the file is of no type of curves.
std::optional<ForceCurveFile> openCurves(const std::string& file, const CurveFileOptions& options) {
    const bool isThere = nameTable(options) || holdsForceCurves(FileBytes(file));
    return isThere ? std::optional<ForceCurveFile>(std::in_place, file, options.read)
                   : std::nullopt;
}

Json spectrumJson(const ThermalSpectrum& spectrum) {
    return {{"points", spectrum.power.size()},
            {"highest_frequency_hz", spectrum.frequency.back()},
            {"averages", known(spectrum.averages)},
            {"resonance_hz", known(spectrum.resonance)},
            {"quality_factor", known(spectrum.quality)},
            {"stiffness_n_m", known(spectrum.stiffness)}};
}

void printSpectrum(const ThermalSpectrum& spectrum) {
    std::cout << "Nanosurf .nid thermal spectrum: " << spectrum.power.size() << " points up to "
              << quantityText(spectrum.frequency.back(), "Hz") << '\n'
              << "  fit of its program: resonance " << quantityText(spectrum.resonance, "Hz")
              << ", quality factor " << quantityText(spectrum.quality, "") << ", spring constant "
              << quantityText(spectrum.stiffness, "N/m") << '\n';
}

/// Prints what a file holds that has no image. @param facts for JSON, print for people
template <class Facts, class Print>
void printWithoutImage(const std::string& file, bool json, const char* key, const Facts& facts,
                       const Print& print) {
    if (json) {
        std::cout << jsonText(Json{{"file", pathText(file)},
                                   {"sha256", sha256Of(FileBytes(file))},
                                   {key, facts()}})
                  << '\n';
        return;
    }
    std::cout << printable(file) << '\n';
    print();
}

}  // namespace

std::optional<ForceCurveFile> curvesBeside(const std::string& file,
                                           const CurveFileOptions& options) {
    try {
        std::optional<ForceCurveFile> curves = openCurves(file, options);
        return curves && curves->hasImage() ? std::move(curves) : std::nullopt;
    } catch (const InputError& error) {
        std::cerr << "note: its force curves cannot be read: " << error.what() << '\n';
        return std::nullopt;
    }
}

bool showWithoutImage(const std::string& file, const CurveFileOptions& options, bool json) {
    if (const std::optional<ForceCurveFile> curves = openCurves(file, options)) {
        printWithoutImage(
            file, json, "force_curves", [&] { return curvesJson(*curves, options); },
            [&] { printCurves(*curves, options); });
        return true;
    }
    const FileBytes bytes(file);
    if (!holdsThermalSpectrum(bytes)) {
        return false;
    }
    const ThermalSpectrum spectrum = readThermalSpectrum(bytes);
    printWithoutImage(
        file, json, "thermal_spectrum", [&] { return spectrumJson(spectrum); },
        [&] { printSpectrum(spectrum); });
    return true;
}

nlohmann::ordered_json curvesJson(const ForceCurveFile& file, const CurveFileOptions& options) {
    Json json = {{"format", file.format()},        {"count", file.count()},
                 {"columns", file.grid().columns}, {"rows", file.grid().rows},
                 {"has_image", file.hasImage()},   {"notes", file.notes()},
                 {"curves", Json::array()}};
    for (const std::size_t index : indexesOf(file, options, file.count())) {
        json["curves"].push_back(curveJson(file, index));
    }
    return json;
}

void printCurves(const ForceCurveFile& file, const CurveFileOptions& options) {
    if (options.index) {
        (void)file.position(*options.index);  // refuses an index that is not there
    }
    std::cout << file.format() << ": "
              << (file.count() == 1 ? std::string("one curve")
                                    : std::to_string(file.count()) + " curves");
    if (const CurveGrid grid = file.grid(); grid.columns > 0) {
        std::cout << " of a grid of " << grid.columns << " x " << grid.rows;
    }
    std::cout << "\n\n";
    const std::vector<std::size_t> indexes = indexesOf(file, options, kShownCurves);
    for (const std::size_t index : indexes) {
        printCurve(file, index);
    }
    if (!options.index && indexes.size() < file.count()) {
        std::cout << "... and " << file.count() - indexes.size() << " more; --index shows one\n";
    }
    for (const std::string& note : file.notes()) {
        std::cout << "- " << printable(note) << '\n';
    }
}

std::vector<std::string> missingIn(const MeasuredForceCurve& curve) {
    const auto lacks = [&curve](const std::vector<double> CurveSegment::*array) {
        return std::ranges::all_of(curve.segments, [array](const CurveSegment& segment) {
            return (segment.*array).empty();
        });
    };
    std::vector<std::string> missing;
    if (!(curve.stiffness > 0.0)) {
        missing.emplace_back("spring constant");
    }
    if (!(curve.invols > 0.0) && lacks(&CurveSegment::deflection) && lacks(&CurveSegment::force)) {
        missing.emplace_back("optical sensitivity");
    }
    if (lacks(&CurveSegment::time)) {
        missing.emplace_back("times");
    }
    return missing;
}

}  // namespace asperity
