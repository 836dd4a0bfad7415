#include "app/commands/CaseFiles.h"
#include "app/commands/Commands.h"
#include "app/commands/CurveReport.h"
#include "app/commands/LevelingOption.h"
#include "app/commands/OptionChecks.h"
#include "app/commands/ProgressLine.h"
#include "app/commands/ScaleOption.h"
#include "app/commands/TextTable.h"
#include "app/program/EndSignals.h"
#include "app/program/JsonText.h"
#include "app/reports/MeasureReport.h"
#include "core/Error.h"
#include "core/PrintableText.h"
#include "core/SiFormat.h"
#include "core/io/heightmap/HeightStatistics.h"
#include "core/io/heightmap/PhysicalUnit.h"
#include "core/io/heightmap/ScanFile.h"
#include "core/io/scene/SceneFile.h"
#include "core/surface/GivenScale.h"
#include "core/surface/leveling/Leveling.h"
#include "core/words/SceneWords.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <memory>
#include <new>
#include <nlohmann/json.hpp>
#include <span>
#include <sstream>
#include <string_view>
#include <utility>

namespace asperity {

namespace {

struct InfoOptions {
    std::string file;
    std::string channel;  ///< empty: all
    bool json = false;
    GivenScale scale;
    CurveFileOptions curves;
};

/// An open file, and which of its channels are shown.
struct Report {
    const ScanFile& file;
    std::string path;  ///< as the user gave it
    std::vector<const ScanChannel*> channels;
    const ForceCurveFile* curves;  ///< that the file holds, too; null: none
    const CurveFileOptions& curveOptions;
};

Report reportOf(const ScanFile& file, const ForceCurveFile* curves, const InfoOptions& options) {
    Report shown{.file = file,
                 .path = options.file,
                 .channels = {},
                 .curves = curves,
                 .curveOptions = options.curves};
    if (!options.channel.empty()) {
        shown.channels = {&channelNamed(file.contents(), options.file, options.channel)};
        return shown;
    }
    for (const ScanChannel& channel : file.contents().channels) {
        shown.channels.push_back(&channel);
    }
    return shown;
}

bool isDefault(const HeightMapFile& file, const ScanChannel& channel) {
    return &channel == &file.channels.at(file.defaultChannel) && isTopography(channel);
}

/// Facts on a channel's pixels.
struct PixelFacts {
    HeightStatistics statistics;
    /// The corner pixels: they show which way up the image lies. NaN: no data.
    double topLeft = 0.0;
    double topRight = 0.0;
    double bottomLeft = 0.0;
    double bottomRight = 0.0;
};

PixelFacts pixelFacts(const ScanFile& file, const ScanChannel& channel) {
    PixelFacts facts;
    const int bottom = channel.map.rows - 1;
    facts.statistics = heightStatistics([&](const TakeRow& take) {
        file.forEachRow(channel, [&](int row, std::span<const double> values) {
            if (row == 0) {
                facts.topLeft = values.front();
                facts.topRight = values.back();
            }
            if (row == bottom) {
                facts.bottomLeft = values.front();
                facts.bottomRight = values.back();
            }
            take(values);
        });
    });
    return facts;
}

/// NaN, of a channel without a valid pixel, becomes null.
nlohmann::json channelJson(const HeightMapFile& file, const ScanChannel& channel,
                           const PixelFacts& facts) {
    const HeightStatistics& statistics = facts.statistics;
    return {{"name", channel.name},
            {"unit", channel.unit},
            {"direction", channel.direction},
            {"is_height", channel.isHeight()},
            {"is_default", isDefault(file, channel)},
            {"columns", channel.map.columns},
            {"rows", channel.map.rows},
            {"size_known", channel.hasSize()},
            {"lateral_unit", channel.lateralUnit},
            {"size_x_m", channel.map.sizeX()},
            {"size_y_m", channel.map.sizeY()},
            {"pitch_x_m", channel.map.pitchX},
            {"pitch_y_m", channel.map.pitchY},
            {"origin_x_m", channel.originX},
            {"origin_y_m", channel.originY},
            {"min", statistics.lowest},
            {"max", statistics.highest},
            {"mean", statistics.mean},
            {"rms", statistics.rms},
            {"invalid_pixels", statistics.invalidPixels},
            {"corners",
             {{"top_left", facts.topLeft},
              {"top_right", facts.topRight},
              {"bottom_left", facts.bottomLeft},
              {"bottom_right", facts.bottomRight}}},
            {"metadata", channel.metadata},
            {"provenance", provenanceJson(channel.provenance)}};
}

/// One of each shown channel.
std::vector<PixelFacts> factsOf(const Report& shown) {
    std::vector<PixelFacts> facts;
    for (const ScanChannel* const channel : shown.channels) {
        facts.push_back(pixelFacts(shown.file, *channel));
    }
    return facts;
}

/// Returns the notes of the reader, those on pixels, and those that hold for every scan.
std::vector<std::string> notesOf(const Report& shown, const std::vector<PixelFacts>& facts) {
    const HeightMapFile& file = shown.file.contents();
    std::vector<std::string> notes = file.notes;
    for (std::size_t i = 0; i < facts.size(); ++i) {
        const ScanChannel& channel = *shown.channels[i];
        std::ranges::copy(ownNotes(channel), std::back_inserter(notes));
        if (std::isnan(facts[i].statistics.mean)) {
            notes.push_back("channel '" + channel.name +
                            "' holds no valid pixel: commands that need heights refuse it");
        }
    }
    if (std::ranges::any_of(shown.channels,
                            [](const ScanChannel* channel) { return isTopography(*channel); })) {
        notes.emplace_back(kScanHoldsItsTip);
    }
    return notes;
}

/// Prints a JSON text two levels deep.
void printIndented(std::string_view text) {
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
        std::cout << "    " << text.substr(0, end);
        text.remove_prefix(end);
    }
}

/// One channel after the other: the texts of all of them together would take several times their
/// memory. Their pixels are read before, so that a failure prints nothing.
void printJson(const Report& shown) {
    const HeightMapFile& file = shown.file.contents();
    const std::vector<PixelFacts> facts = factsOf(shown);
    const ScanChannel& first = file.channels.at(file.defaultChannel);
    const nlohmann::json defaultName =
        isTopography(first) ? nlohmann::json(first.name) : nlohmann::json();
    nlohmann::json report = {
        {"file", pathText(shown.path)},   {"format", file.format},
        {"sha256", shown.file.sha256()},  {"default_channel", defaultName},
        {"notes", notesOf(shown, facts)}, {"provenance", provenanceJson(file.provenance)}};
    if (shown.curves != nullptr) {
        report["force_curves"] = curvesJson(*shown.curves, shown.curveOptions);
    }
    const std::string rest = jsonText(report);
    std::cout << "{\n  \"channels\": [";
    for (std::size_t i = 0; i < facts.size(); ++i) {
        std::cout << (i == 0 ? "\n" : ",\n");
        printIndented(jsonText(channelJson(file, *shown.channels[i], facts[i])));
    }
    std::cout << "\n  ]," << rest.substr(1) << '\n';
}

std::string sizeText(const ScanChannel& channel) {
    if (!(channel.map.pitchX > 0.0)) {
        return "size unknown";
    }
    return quantityText(channel.map.sizeX(), channel.lateralUnit) + " x " +
           quantityText(channel.map.sizeY(), channel.lateralUnit);
}

TableRow channelRow(const ScanFile& file, const ScanChannel& channel,
                    const HeightStatistics& statistics) {
    const auto value = [&channel](double number) {
        return std::isnan(number) ? std::string("-") : quantityText(number, channel.unit);
    };
    return {(isDefault(file.contents(), channel) ? "* " : "  ") + channel.name,
            channel.direction,
            std::to_string(channel.map.columns) + " x " + std::to_string(channel.map.rows),
            sizeText(channel),
            value(statistics.lowest),
            value(statistics.highest),
            value(statistics.mean),
            value(statistics.rms),
            std::to_string(statistics.invalidPixels)};
}

/// Explains the mark of a channel.
std::string legendOf(const Report& shown) {
    const HeightMapFile& file = shown.file.contents();
    if (!isTopography(file.channels.at(file.defaultChannel))) {
        return "No channel is a height map; ";
    }
    const bool showsDefault = std::ranges::any_of(
        shown.channels, [&file](const ScanChannel* channel) { return isDefault(file, *channel); });
    return showsDefault ? "* taken when no channel is named; " : "";
}

/// Prints that of the default channel, or of the one that was asked for.
void printProvenance(const Report& shown) {
    const HeightMapFile& file = shown.file.contents();
    const ScanChannel& channel = shown.channels.size() == 1 ? *shown.channels.front()
                                                            : file.channels.at(file.defaultChannel);
    std::cout << "\nWhere the numbers of '" << printable(channel.name) << "' come from\n";
    for (const Provenance& entry : provenanceOf(file, channel)) {
        std::cout << "- " << printable(entry.what + ": " + entry.value) << " ("
                  << printable(entry.source) << ")\n";
    }
}

void printForPeople(const Report& shown) {
    const HeightMapFile& file = shown.file.contents();
    std::vector<TableRow> rows = {
        {"  channel", "direction", "pixels", "size", "min", "max", "mean", "rms", "invalid"}};
    const std::vector<PixelFacts> facts = factsOf(shown);  // may refuse a pixel
    for (std::size_t i = 0; i < facts.size(); ++i) {
        rows.push_back(channelRow(shown.file, *shown.channels[i], facts[i].statistics));
    }
    std::cout << printable(shown.path) << "\n" << file.format << "\n\n";
    printTable(std::move(rows), 2);
    std::cout << '\n' << legendOf(shown) << "rms is about the mean\n";
    for (const std::string& note : notesOf(shown, facts)) {
        std::cout << "- " << printable(note) << '\n';
    }
    printProvenance(shown);
    if (shown.curves != nullptr) {
        std::cout << '\n';
        printCurves(*shown.curves, shown.curveOptions);
    }
}

void showScan(const ScanFile& file, const InfoOptions& options) {
    const std::optional<ForceCurveFile> curves = curvesBeside(options.file, options.curves);
    const Report shown = reportOf(file, curves ? &*curves : nullptr, options);
    if (options.json) {
        printJson(shown);
    } else {
        printForPeople(shown);
    }
}

/// A file may hold an image, force curves, or both. Exported images may have titles like curves:
/// only what is no image is taken as curves alone.
void showInfo(const InfoOptions& options) {
    if (nameTable(options.curves)) {
        (void)showWithoutImage(options.file, options.curves, options.json);
        return;
    }
    std::unique_ptr<const ScanFile> scan;
    try {
        scan = std::make_unique<const ScanFile>(options.file, options.scale);
    } catch (const InputError&) {
        if (!showWithoutImage(options.file, options.curves, options.json)) {
            throw;
        }
        return;
    }
    showScan(*scan, options);
}

struct MeasureOptions {
    std::vector<std::string> inputs;
    std::string channel;
    GivenScale scale;
    std::optional<LevelingSteps> leveling;
    std::optional<LevelPoints> levelPoints;
    std::vector<double> rectangle;  ///< x0, y0, x1, y1 [m]; empty: all pixels
    std::vector<double> profile;    ///< x0, y0, x1, y1 [m]; empty: none
    std::vector<double> low;        ///< a stretch of the profile [m]; empty: none
    std::vector<double> high;       ///< [m]
    int samples = 0;                ///< 0: one a pixel
    std::string out;                ///< table of the profile; empty: none
    std::string psd;                ///< table of the power spectrum; empty: none
    bool json = false;
    bool csv = false;
};

/// A height map after leveling, without smoothing, and how it came about.
struct LeveledChannel {
    HeightMap map;
    MeasuredMap facts;  ///< without measures
};

SampleDescription sampleOf(const std::string& input, const MeasureOptions& options) {
    SampleDescription sample = sceneFromInput(input).sample;
    if (sample.shape) {
        throw Error(input + ": a scene with a shape has no height map to measure");
    }
    if (!options.channel.empty()) {
        sample.channel = options.channel;
    }
    sample.scale = merged(sample.scale, options.scale);
    sample.leveling = options.leveling.value_or(sample.leveling);
    if (options.levelPoints) {
        sample.levelPoints = options.levelPoints;
    }
    return sample;
}

LeveledChannel load(const std::string& input, const MeasureOptions& options) {
    const SampleDescription sample = sampleOf(input, options);
    HeightChannel read = [&] {
        ProgressLine line("loading");
        return ScanFile(sample.file, sample.scale).readHeightChannel(sample.channel, &line);
    }();
    requireHeights(read.channel.map, sample.file);
    LeveledMap<HeightMap> level = [&] {
        ProgressLine line("leveling");
        return leveledInSteps(std::move(read.channel.map), sample.leveling, sample.levelPoints,
                              &line);
    }();
    std::ranges::move(levelingNotes(level.removed), std::back_inserter(read.notes));
    return {.map = std::move(level.map),
            .facts = {.file = sample.file,
                      .channel = read.channel.name,
                      .leveling = textOf(sample.leveling),
                      .notes = std::move(read.notes)}};
}

MeasuredProfile measuredProfile(const MeasureOptions& options, const HeightMap& map) {
    const Vector2 from(options.profile[0], options.profile[1]);
    const Vector2 to(options.profile[2], options.profile[3]);
    const int samples =
        options.samples > 0 ? options.samples : usualSamples(map.pitchX, map.pitchY, from, to);
    MeasuredProfile measured;
    measured.profile = profileOf(bilinearField(map).at, from, to, samples);
    const double length = measured.profile.length();
    measured.ends = readingBetween(measured.profile, 0.0, length);
    measured.fittedAngle = fittedAngle(measured.profile, {0.0, length});
    measured.grating = gratingHeight(measured.profile);
    if (!options.low.empty()) {
        measured.twoLevels = stepHeight(measured.profile, {options.low[0], options.low[1]},
                                        {options.high[0], options.high[1]});
        if (!measured.twoLevels) {
            throw Error("--low or --high holds no sample of the profile with data");
        }
    }
    return measured;
}

MeasuredMap measuresOf(const MeasureOptions& options, LeveledChannel level) {
    const HeightRows rows = rowsOf(level.map);
    MeasuredMap measured = std::move(level.facts);
    measured.columns = rows.columns;
    measured.rows = rows.rows;
    measured.sizeX = rows.sizeX();
    measured.sizeY = rows.sizeY();
    const std::vector<double>& corners = options.rectangle;
    measured.rectangle = corners.empty() ? allPixels(rows)
                                         : pixelsBetween(rows, Vector2(corners[0], corners[1]),
                                                         Vector2(corners[2], corners[3]));
    ProgressLine line("measuring");
    ProgressPart first(&line, 0.0, 0.3);
    measured.roughness = roughnessOf(rows, measured.rectangle, &first);
    ProgressPart second(&line, 0.3, 0.8);
    measured.texture = textureOf(rows, measured.rectangle, &second);
    if (!options.psd.empty()) {
        ProgressPart third(&line, 0.8, 1.0);
        measured.spectrum = powerSpectrumOf(rows, measured.rectangle, &third);
    }
    if (!options.profile.empty()) {
        measured.profile = measuredProfile(options, level.map);
    }
    return measured;
}

void measureOne(const MeasureOptions& options) {
    const std::string& input = options.inputs.front();
    requireWritableTable(options.out, {input});
    requireWritableTable(options.psd, {input});
    const MeasuredMap measured = measuresOf(options, load(input, options));
    if (options.json) {
        std::cout << measuresJson(measured) << '\n';
    } else {
        printMeasures(std::cout, measured);
    }
    if (measured.spectrum) {
        writeSpectrum(options.psd, provenanceOf(measured, "power spectrum"), *measured.spectrum);
    }
    if (!options.out.empty()) {
        writeTable(options.out, [&](std::ostream& out, Progress* /*progress*/) {
            writeProfile(out, measured, measured.profile->profile);
        });
    }
}

/// Adds the row of a file, or reports why there is none. @return whether it worked
bool measureInto(RoughnessTable& table, const std::string& input, const MeasureOptions& options) {
    std::string reason;
    try {
        table.add(input, measuresOf(options, load(input, options)));
        return true;
    } catch (const Canceled&) {
        throw;
    } catch (const std::bad_alloc&) {
        reason = "out of memory";
    } catch (const std::exception& error) {
        reason = messageOf(error);
    }
    const bool namesFile = reason.starts_with(input + ":");
    std::cerr << "asperity: " << (namesFile ? "" : printable(input) + ": ") << printable(reason)
              << '\n';
    table.addUnmeasured(input);
    return false;
}

/// Measures files one after the other into a table; a bad one is reported and the next is taken.
/// @throw FileError at the end when there was any; Canceled
void measureMany(const MeasureOptions& options) {
    RoughnessTable table(std::cout);
    std::size_t failed = 0;
    for (const std::string& input : options.inputs) {
        failed += measureInto(table, input, options) ? 0 : 1;
    }
    table.close();
    if (failed > 0) {
        throw FileError(std::to_string(failed) + " of " + std::to_string(options.inputs.size()) +
                            " files",
                        "could not be measured");
    }
}

void measure(const MeasureOptions& options) {
    if (options.csv) {
        measureMany(options);
    } else if (options.inputs.size() > 1) {
        throw CLI::ValidationError("INPUT", "many files are measured into a table: add --csv");
    } else {
        measureOne(options);
    }
}

CLI::Option* addNumbers(CLI::App& command, const std::string& name, std::vector<double>& values,
                        int count, const std::string& meaning) {
    return command.add_option(name, values, meaning)
        ->delimiter(',')
        ->expected(count)
        ->check(finiteNumber());
}

void addProfileOptions(CLI::App& command, MeasureOptions& options) {
    constexpr int kMaxSamples = 10'000'000;
    CLI::Option* profile =
        addNumbers(command, "--profile", options.profile, 4,
                   "heights along the line from x0,y0 to x1,y1, bilinear between pixels [m]");
    command
        .add_option("--samples", options.samples,
                    "samples of the profile, both ends included (default: one a pixel)")
        ->check(CLI::Range(2, kMaxSamples))
        ->needs(profile);
    CLI::Option* low = addNumbers(command, "--low", options.low, 2,
                                  "stretch of the profile, from,to: the lower level of a step, "
                                  "with --high [m]")
                           ->needs(profile);
    CLI::Option* high =
        addNumbers(command, "--high", options.high, 2, "the upper level [m]")->needs(low);
    low->needs(high);
    command.add_option("--out", options.out, "CSV file to write the profile to")
        ->check(notEmpty())
        ->needs(profile);
}

}  // namespace

void addInfoCommand(CLI::App& program) {
    auto options = std::make_shared<InfoOptions>();
    CLI::App* command = program.add_subcommand(
        "info", "Show channels, size and height statistics of a height-map file, and the force "
                "curves of a file, their segments and calibration");
    command->add_option("FILE", options->file, "height-map file, or file of force curves")
        ->required();
    command->add_option("--channel", options->channel,
                        "name of the one channel to show (default: all)");
    addScaleOptions(*command, options->scale);
    command->add_flag("--json", options->json, "print JSON with SI values in full precision");
    addCurveFileOptions(*command, options->curves);
    command->callback([options] { showInfo(*options); });
}

void addMeasureCommand(CLI::App& program) {
    const auto options = std::make_shared<MeasureOptions>();
    CLI::App* command = program.add_subcommand(
        "measure", "Measure roughness (ISO 25178-2) of height maps, a profile, its angle and step "
                   "heights, after leveling and without smoothing");
    command->add_option("INPUT", options->inputs, "height map, or scene file; many with --csv")
        ->required()
        ->check(notEmpty());
    command->add_option("--channel", options->channel,
                        "name of the channel (default: the topography)");
    addScaleOptions(*command, options->scale);
    addLevelingOptions(*command, options->leveling, options->levelPoints,
                       "default: as in the scene, or plane");
    addNumbers(*command, "--rectangle", options->rectangle, 4,
               "roughness of the pixels whose centers lie between the corners x0,y0 and x1,y1, "
               "from the lower left corner of the scan [m]");
    addProfileOptions(*command, *options);
    CLI::Option* psd =
        command
            ->add_option("--psd", options->psd,
                         "CSV file to write the power spectral density to, areal, mean over all "
                         "directions")
            ->check(notEmpty());
    CLI::Option* json =
        command->add_flag("--json", options->json, "print JSON with SI values in full precision");
    command
        ->add_flag("--csv", options->csv,
                   "print a table of the roughness of all files, a row each, with SI values in "
                   "full precision")
        ->excludes(json)
        ->excludes(psd)
        ->excludes("--profile");
    command->callback([options] { measure(*options); });
}

}  // namespace asperity
