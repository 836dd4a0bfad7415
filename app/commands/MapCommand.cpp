#include "app/commands/MapCommand.h"

#include "app/commands/MapOptions.h"
#include "app/commands/ProgressLine.h"
#include "app/commands/VirtualDisplay.h"
#include "app/maps/MapKey.h"
#include "app/maps/MapRun.h"
#include "app/maps/MapSheets.h"
#include "core/Error.h"
#include "core/FormattedText.h"
#include "core/PrintableText.h"
#include "core/TemporaryFile.h"

#include <chrono>
#include <iostream>
#include <memory>
#include <optional>
#include <vector>

namespace asperity {

namespace {

PartUse useOf(const MapOptions& options) {
    return options.resume ? PartUse::Resume : options.force ? PartUse::Replace : PartUse::New;
}

/// Refuses files that cannot be written, or that the user may want to keep, before long work is
/// done for them. An unfinished map's own files may go.
void requireTargets(const MapOptions& options, const MapFiles& files, const MapPlan& plan,
                    const std::string& scan) {
    std::vector<std::filesystem::path> targets{files.gwy(), files.vti(), files.exr()};
    for (int sheet = 1; !options.noPictures && sheet <= sheetCount(plan); ++sheet) {
        targets.push_back(files.sheet(sheet));
    }
    std::error_code none;
    for (const std::filesystem::path& file : targets) {
        for (const std::string& input : {options.scene, scan}) {
            if (std::filesystem::equivalent(input, file, none)) {
                throw Error(file.string() + ": this is an input; give another output file");
            }
        }
        const bool isOwn = options.resume && std::filesystem::exists(files.part(), none);
        if (std::filesystem::exists(file, none) && !options.force && !isOwn) {
            throw Error(file.string() + ": exists; --force replaces it");
        }
        requireWritable(file);
    }
}

LoadedScene loadFor(const MapOptions& options) {
    ProgressLine line("loading");
    // With all terms of the model: no map has to keep up with a tick.
    LoadedScene loaded = loadScene(options.scene, options.overrides, &line, ModelFit::Later);
    reportTo(&line, 1.0);
    return loaded;
}

/// Computes what is missing. @return whether it was not canceled
bool compute(const MapOptions& options, const Scene& scene, const MapPlan& plan, MapPart& part) {
    try {
        ProgressLine line("mapping");
        computeMap(scene, plan, part, options.threads, &line);
        return true;
    } catch (const Canceled&) {
        return false;
    }
}

/// A canceled map is written, too, whatever the signal: what it lacks holds no data.
void writeAll(const MapFiles& files, const LoadedScene& loaded, const MapPlan& plan,
              const MapPart& part, bool withPictures) {
    const CancelOnSignal deaf;
    if (withPictures) {
        writeMapSheets(files, plan, part);
    }
    writeMapFiles(files, loaded, plan, part, nullptr);
}

std::string speedText(const MapPlan& plan, int rows, double seconds) {
    const double curves = static_cast<double>(rows) * plan.grid.columns;
    return formatted("%d x %d pixels; %.0f of them computed in %.3g s: %.4g a second",
                     plan.grid.columns, plan.grid.rows, curves, seconds,
                     seconds > 0.0 ? curves / seconds : 0.0);
}

void map(const MapOptions& options) {
    const MapFiles files(options.out);
    const LoadedScene loaded = loadFor(options);
    const MapPlan plan = planMap(loaded.scene, options.request);
    requireMapFits(plan);
    requireTargets(options, files, plan, loaded.scene.description.sample.file);
    std::optional<VirtualDisplay> display;  // before long work is done
    if (!options.noPictures) {
        display.emplace();
    }
    MapPart part(files.part(), plan, mapKey(loaded, plan), useOf(options));
    for (const std::string& note : notesOn(loaded)) {
        std::cerr << "note: " << printable(note) << '\n';
    }
    const int before = part.count();
    const auto begin = std::chrono::steady_clock::now();
    const bool isWhole = compute(options, loaded.scene, plan, part);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    writeAll(files, loaded, plan, part, !options.noPictures);
    if (!isWhole) {
        throw Error(formatted("canceled: %d of %d rows are in ", part.count(), part.rows()) +
                    files.gwy().string() +
                    ", the others hold no data; --resume goes on with the map");
    }
    part.remove();
    std::cout << speedText(plan, part.rows() - before, took.count()) << '\n';
}

}  // namespace

void addMapCommand(CLI::App& program) {
    CLI::App* command = program.add_subcommand(
        "map",
        "Map adhesion, stiffness, deformation and friction over a scan: a force curve at each "
        "pixel, or a raster at constant force");
    const auto options = std::make_shared<MapOptions>();
    addMapOptions(*command, *options);
    command->callback([options] { map(*options); });
}

}  // namespace asperity
