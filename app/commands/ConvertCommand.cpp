#include "app/commands/Commands.h"
#include "app/commands/ConvertCurve.h"
#include "app/commands/ConvertMap.h"
#include "app/commands/ConvertTargets.h"
#include "app/commands/LevelingOption.h"
#include "app/commands/OptionChecks.h"
#include "app/commands/ProgressLine.h"
#include "app/commands/ScaleOption.h"
#include "app/program/EndSignals.h"
#include "app/program/LoadedScene.h"
#include "app/recording/Replay.h"
#include "app/recording/RunPacking.h"
#include "app/runs/OutputFolder.h"
#include "app/runs/RunFolder.h"
#include "core/Error.h"
#include "core/PrintableText.h"
#include "core/io/FileBytes.h"
#include "core/surface/fit/GaussianFilter.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <new>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

namespace {

/// Refuses before anything is done what no input could be converted with. @throw Error
void makeFolder(const std::string& folder) {
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    if (failure || !std::filesystem::is_directory(folder, failure)) {
        throw FileError(folder, "the folder cannot be made");
    }
}

/// A scan is often the only copy of a measurement.
void refuseToOverwriteInputs(const ConvertOptions& options, const ConvertedFile& file) {
    std::vector<std::string> inputs{options.input};
    inputs.insert(inputs.end(), options.others.begin(), options.others.end());
    for (const std::string& input : inputs) {
        std::error_code ignored;
        if (std::filesystem::equivalent(input, file.output, ignored)) {
            throw Error("its output " + file.output + " is " +
                        (input == file.input ? "the file itself" : "another input") +
                        "; name another folder");
        }
    }
}

Converted convertFile(const ConvertOptions& options, const ConvertedFile& file) {
    if (isCurveTable(file.output)) {
        return convertCurve(options, file);
    }
    return options.all ? convertAll(options, file) : convertMap(options, file);
}

void convertOne(const ConvertOptions& options, const ConvertedFile& file) {
    refuseToOverwriteInputs(options, file);
    requireWritableTargets(options, file);
    const Converted converted = convertFile(options, file);
    for (const std::string& note : converted.notes) {
        std::cerr << "note: " << printable(file.input) << ": " << printable(note) << '\n';
    }
    std::cout << printable(file.input) << " -> " << printable(file.output) << ": "
              << printable(converted.summary) << std::endl;  // a line when it is true
}

/// @return whether it worked
bool tryOne(const ConvertOptions& options, const ConvertedFile& file) {
    std::string reason;
    try {
        convertOne(options, file);
        return true;
    } catch (const Canceled&) {
        throw;
    } catch (const std::bad_alloc&) {
        reason = "out of memory";
    } catch (const std::exception& error) {
        reason = messageOf(error);
    }
    const bool namesFile = reason.starts_with(file.input + ":");
    std::cerr << "asperity: " << (namesFile ? "" : printable(file.input) + ": ")
              << printable(reason) << '\n';
    return false;
}

/// A file of the folder for each input: "scan.spm" becomes "scan.gsf"; "scan.001" and "scan.002",
/// which would share it, "scan.001.gsf" and "scan.002.gsf". An input that would still share one has
/// no output: the text is empty.
std::vector<ConvertedFile> filesInFolder(const std::vector<std::string>& inputs,
                                         const std::filesystem::path& folder,
                                         const std::string& extension) {
    std::map<std::string, int> stems;
    for (const std::string& input : inputs) {
        ++stems[std::filesystem::path(input).stem().string()];
    }
    std::set<std::string> taken;
    std::vector<ConvertedFile> files;
    for (const std::string& input : inputs) {
        const std::filesystem::path path(input);
        const std::string stem = path.stem().string();
        const bool isClear = stems[stem] == 1 || path.extension() == extension;
        const std::string base = isClear ? stem : path.filename().string();
        std::string name = base + extension;
        for (int number = 2; !taken.insert(name).second; ++number) {
            name = base + "-" + std::to_string(number) + extension;
        }
        files.push_back({input, (folder / name).string()});
    }
    return files;
}

/// Converts files one after the other and says of each what came out of it; a bad one is reported
/// and left out. @throw Error at the end when there was any; Canceled
void convertMany(const ConvertOptions& options) {
    std::vector<std::string> inputs{options.input};
    inputs.insert(inputs.end(), options.others.begin(), options.others.end());
    const std::string extension =
        (options.extension.starts_with('.') ? "" : ".") + options.extension;
    requireTarget(options, "--to", "OUT" + extension);
    makeFolder(options.folder);
    std::size_t failed = 0;
    for (const ConvertedFile& file : filesInFolder(inputs, options.folder, extension)) {
        failed += tryOne(options, file) ? 0 : 1;
    }
    if (failed > 0) {
        throw Error(std::to_string(failed) + " of " + std::to_string(inputs.size()) +
                    " files could not be converted");
    }
}

constexpr std::array<std::string_view, 4> kTableFiles{run_files::kInput, run_files::kLog,
                                                      run_files::kEnergy, run_files::kTables};

bool isTable(std::string_view name) {
    return std::ranges::find(kTableFiles, name) != kTableFiles.end();
}

/// Files of a run, those that match.
template <class Matches>
void copyFiles(const std::filesystem::path& run, const std::filesystem::path& out,
               const Matches& matches) {
    for (const std::string& name : runFileNames()) {
        if (isThere(run / name) && matches(name)) {
            copyTo(FileBytes(run / name), out / name);
        }
    }
}

void requireWhole(const std::filesystem::path& run) {
    const RunState state = stateOf(run);
    if (state == RunState::Unfinished || state == RunState::Recording) {
        throw Error(run.string() + ": " + sentenceOf(state) + "; only a whole run is converted");
    }
}

void writeText(const std::filesystem::path& folder, const std::filesystem::path& out) {
    const RecordedRun run = readRun(folder);
    const LoadedScene loaded = loadSceneOnTerminal(folder / run_files::kScene, {});
    requireSameScan(loaded, run.scan);
    unpackRun(folder, loaded.scene, run, out);
}

void write(const std::filesystem::path& run, const std::filesystem::path& out, RunFormat format) {
    copyFiles(run, out, [](std::string_view name) { return !isTable(name); });
    if (format == RunFormat::Csv) {
        writeText(run, out);
    } else {
        copyFiles(run, out, [](std::string_view name) {
            return isTable(name) && name != run_files::kTables;
        });
        packRun(out);
    }
}

/// Size of the tables of a run [byte].
std::uintmax_t tableBytes(const std::filesystem::path& run) {
    std::uintmax_t bytes = 0;
    for (const std::string_view name : kTableFiles) {
        std::error_code missing;
        const std::uintmax_t size = std::filesystem::file_size(run / name, missing);
        bytes += missing ? 0 : size;
    }
    return bytes;
}

/// Writes a run into another folder, with its tables in another format. From the compact format to
/// text, the scan must be where its scene says: the log's last digits are computed again.
/// @param force a run that is there may be deleted
/// @throw Error, InputError
void convertRun(const std::string& run, const std::string& out, RunFormat format, bool force) {
    std::error_code missing;
    if (!std::filesystem::is_directory(run, missing)) {
        throw InputError(run, "", "expected the folder of a run");
    }
    if (std::filesystem::equivalent(run, out, missing)) {
        throw Error("OUT must be another folder than the run");
    }
    requireWhole(run);
    if (formatOf(run) == format) {
        throw Error(run + ": its tables have this format already");
    }
    OutputFolder folder(out, convertedRun(), force);
    folder.collect([&](const std::filesystem::path& target) { write(run, target, format); });
    folder.commit();
    std::cout << printable(out) << ": tables of " << tableBytes(out) << " bytes, before "
              << tableBytes(run) << " bytes\n";
}

void convertOne(const ConvertOptions& options) {
    const ConvertedFile file{options.input, options.others.front()};
    requireWritableTargets(options, file);
    const Converted converted = convertFile(options, file);
    for (const std::string& note : converted.notes) {
        std::cerr << "note: " << printable(note) << '\n';
    }
    std::cerr << printable(file.output) << ": " << printable(converted.summary) << '\n';
}

void convert(const ConvertOptions& options) {
    const CancelOnSignal cancel;  // between one piece of work and the next, too
    if (!options.folder.empty()) {
        convertMany(options);
        return;
    }
    if (options.others.size() != 1) {
        throw CLI::ValidationError("OUT", "one output file is expected; for many inputs name a "
                                          "folder with --out-dir and a format with --to");
    }
    if (options.runFormat) {
        convertRun(options.input, options.others.front(), *options.runFormat, options.force);
        return;
    }
    convertOne(options);
}

/// A run has none of what the options for maps are about.
void addRunFormat(CLI::App& command, std::optional<RunFormat>& format) {
    const std::vector<CLI::Option*> ofMaps = command.get_options([](const CLI::Option* option) {
        return !option->get_lnames().empty() && !option->check_lname("force") &&
               !option->check_lname("help");
    });
    CLI::Option* const added = addFormatOption(
        command, format, "IN is the folder of a run, OUT another one, its tables are written as");
    for (CLI::Option* const option : ofMaps) {
        added->excludes(option);
    }
}

void addFiles(CLI::App& command, ConvertOptions& options) {
    command
        .add_option("IN", options.input,
                    "height-map file, file of force curves, or the folder of a run")
        ->required();
    command.add_option("OUT", options.others,
                       "file to write; its extension names the format (with --out-dir: more files "
                       "to read)");
    auto* folder = command
                       .add_option("--out-dir", options.folder,
                                   "folder to write a file for each of any number of files IN")
                       ->check(notEmpty());
    auto* format = command
                       .add_option("--to", options.extension,
                                   "with --out-dir, the format by its extension: gsf")
                       ->needs(folder)
                       ->check(notEmpty());
    folder->needs(format);
    command.add_flag("--force", options.force, "replace existing files");
}

void addFormatOptions(CLI::App& command, ConvertOptions& options) {
    command.add_flag("--all", options.all,
                     "write all channels, with names, units, masks and metadata, to .gwy");
    command
        .add_option("--bits", options.bits,
                    "16: write a .tiff of 16-bit counts, with the scale in its description")
        ->check(CLI::IsMember({16}));
}

CLI::Option* addResidual(CLI::App& command, ConvertOptions& options) {
    CLI::Option* residual =
        command.add_flag("--residual", options.residual,
                         "write the residual of smoothing (data minus surface) instead of the map");
    CLI::Option* pixels =
        command
            .add_option(
                "--smoothing-px", options.smoothingPixels,
                "smoothing of the residual's surface: standard deviation [pixel] (default 1)")
            ->check(finiteNumber())
            ->check(CLI::Range(0.0, kMaxSmoothing))
            ->needs(residual);
    command.add_option("--smoothing-m", options.smoothingLength, "the same as a length [m]")
        ->check(finiteNumber())
        ->check(CLI::PositiveNumber)
        ->needs(residual)
        ->excludes(pixels);
    return residual;
}

CLI::Option* addErosion(CLI::App& command, ConvertOptions& options) {
    auto* erode = command
                      .add_option("--erode", options.tipRadius,
                                  "remove the shape of the spherical tip that recorded the "
                                  "heights, by gray-scale erosion, after leveling: its radius "
                                  "[m]")
                      ->check(finiteNumber())
                      ->check(CLI::Range(1e-12, 1.0));
    command
        .add_option("--certainty", options.certainty,
                    "with --erode, a second map to write: 1 where the tip certainly touched the "
                    "surface, 0 elsewhere")
        ->needs(erode)
        ->excludes(command.get_option("--out-dir"))
        ->check(notEmpty());
    return erode;
}

}  // namespace

void addConvertCommand(CLI::App& program) {
    auto options = std::make_shared<ConvertOptions>();
    CLI::App* command = program.add_subcommand(
        "convert", "Write height maps of files in another format: " + targetExtensions() +
                       "; a force curve as .csv; or the tables of a run");
    addFiles(*command, *options);
    addScaleOptions(*command, options->scale);
    command->add_option("--channel", options->channel,
                        "name of the channel (default: the topography)");
    addFormatOptions(*command, *options);
    addLevelingOptions(*command, options->leveling, options->levelPoints, "default none");
    addCurveFileOptions(*command, options->curves);
    CLI::Option* residual = addResidual(*command, *options);
    CLI::Option* erode = addErosion(*command, *options);
    residual->excludes(erode);
    for (const char* other :
         {"--channel", "--bits", "--level", "--level-points", "--residual", "--erode"}) {
        command->get_option("--all")->excludes(command->get_option(other));
    }
    addRunFormat(*command, options->runFormat);
    command->callback([options] { convert(*options); });
}

}  // namespace asperity
