#include "app/commands/MeasureCommand.h"

#include "app/commands/CaseFiles.h"
#include "app/commands/LevelingOption.h"
#include "app/commands/OptionChecks.h"
#include "app/commands/ProgressLine.h"
#include "app/commands/ScaleOption.h"
#include "app/reports/MeasureReport.h"
#include "core/Error.h"
#include "core/io/heightmap/ScanFile.h"
#include "core/io/scene/SceneFile.h"
#include "core/surface/MergedScale.h"
#include "core/surface/leveling/Leveling.h"
#include "core/words/LevelingWords.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <iterator>
#include <memory>
#include <utility>

namespace asperity {

namespace {

struct MeasureOptions {
    std::string input;
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
    bool json = false;
};

/// A height map after leveling, without smoothing, and how it came about.
struct LeveledChannel {
    HeightMap map;
    MeasuredMap facts;  ///< without measures
};

SampleDescription sampleOf(const MeasureOptions& options) {
    SampleDescription sample = sceneFromInput(options.input).sample;
    if (sample.shape) {
        throw Error(options.input + ": a scene with a shape has no height map to measure");
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

LeveledChannel load(const MeasureOptions& options) {
    const SampleDescription sample = sampleOf(options);
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
    measured.profile = profileOf([&map](double x, double y) { return bilinearHeight(map, x, y); },
                                 from, to, samples);
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
    measured.roughness = roughnessOf(rows, measured.rectangle, &line);
    if (!options.profile.empty()) {
        measured.profile = measuredProfile(options, level.map);
    }
    return measured;
}

void measure(const MeasureOptions& options) {
    requireWritableTable(options.out, {options.input});
    const MeasuredMap measured = measuresOf(options, load(options));
    if (options.json) {
        std::cout << measuresJson(measured) << '\n';
    } else {
        printMeasures(std::cout, measured);
    }
    if (!options.out.empty()) {
        writeTable(options.out, [&](std::ostream& out, Progress* /*progress*/) {
            writeProfile(out, measured, measured.profile->profile);
        });
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

void addMeasureCommand(CLI::App& program) {
    const auto options = std::make_shared<MeasureOptions>();
    CLI::App* command = program.add_subcommand(
        "measure", "Measure roughness (Sa, Sq, Sz, Sdr) of a height map, a profile, its angle and "
                   "step heights, after leveling and without smoothing");
    command->add_option("INPUT", options->input, "height map, or scene file")
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
    command->add_flag("--json", options->json, "print JSON with SI values in full precision");
    command->callback([options] { measure(*options); });
}

}  // namespace asperity
