#include "app/commands/ConvertRun.h"

#include "app/commands/ProgressLine.h"
#include "app/program/LoadedScene.h"
#include "app/recording/Replay.h"
#include "app/recording/RunPacking.h"
#include "app/runs/OutputFolder.h"
#include "app/runs/RunFolder.h"
#include "core/Error.h"
#include "core/PrintableText.h"
#include "core/io/FileBytes.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>
#include <string_view>

namespace asperity {

namespace {

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
    requireSameScan(loaded, folder);
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

/// Of the tables of a run [byte].
std::uintmax_t tableBytes(const std::filesystem::path& run) {
    std::uintmax_t bytes = 0;
    for (const std::string_view name : kTableFiles) {
        std::error_code missing;
        const std::uintmax_t size = std::filesystem::file_size(run / name, missing);
        bytes += missing ? 0 : size;
    }
    return bytes;
}

}  // namespace

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
    folder.collect([&](const std::filesystem::path& place) { write(run, place, format); });
    folder.commit();
    std::cout << printable(out) << ": tables of " << tableBytes(out) << " bytes, before "
              << tableBytes(run) << " bytes\n";
}

}  // namespace asperity
