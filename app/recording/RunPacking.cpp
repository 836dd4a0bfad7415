#include "app/recording/RunPacking.h"

#include "app/recording/Recording.h"
#include "app/recording/Replay.h"
#include "core/Error.h"
#include "core/FormattedText.h"
#include "core/TemporaryFile.h"
#include "core/io/TextValue.h"
#include "core/io/recording/PackedTables.h"
#include "core/io/tables/CsvTable.h"
#include "core/io/tables/CsvWriter.h"

#include <algorithm>
#include <optional>
#include <system_error>

namespace asperity {

namespace {

TextTables tablesIn(const std::filesystem::path& folder) {
    return {.input = folder / run_files::kInput,
            .log = folder / run_files::kLog,
            .energy = folder / run_files::kEnergy};
}

}  // namespace

// A process that was killed between packing and removing leaves both; the text has all digits.
RunFormat formatOf(const std::filesystem::path& folder) {
    if (isThere(folder / run_files::kInput)) {
        return RunFormat::Csv;
    }
    if (isThere(folder / run_files::kTables)) {
        return RunFormat::Hdf5;
    }
    throw InputError(folder.string(), "",
                     std::string("holds no run: there is neither ") + run_files::kInput + " nor " +
                         run_files::kTables);
}

void packRun(const std::filesystem::path& folder) {
    TextTables tables = tablesIn(folder);
    if (!isThere(tables.energy)) {
        tables.energy.clear();
    }
    packTables(tables, folder / run_files::kTables);
    for (const char* name : {run_files::kInput, run_files::kLog, run_files::kEnergy}) {
        std::error_code ignored;  // what stays is the same run
        std::filesystem::remove(folder / name, ignored);
    }
}

void unpackRun(const std::filesystem::path& folder, const Scene& scene, const RecordedRun& run,
               const std::filesystem::path& out) {
    requireSameLog(run, replay(scene, run, out));
    TextTables tables = tablesIn(out);
    tables.log.clear();
    std::filesystem::remove(tables.input);  // as it was recorded, by whatever version
    unpackTables(folder / run_files::kTables, tables);
}

namespace {

/// The trace of the passivity observer of these ticks, as it was recorded: it depends on what was
/// before them.
void copyEnergies(const std::filesystem::path& from, const RunSpan& span,
                  const std::filesystem::path& to) {
    CsvRows rows(from);
    CsvWriter csv(to, rows.comments(), rows.columns());
    while (rows.next()) {
        const std::optional<double> time = parseNumber(rows.cells().front());
        if (time && *time >= span.from && *time <= span.to) {
            for (const std::string& cell : rows.cells()) {
                csv.add(std::string_view(cell));
            }
            csv.endRow();
        }
    }
    csv.close();
}

/// Returns the file of the trace as text. @param scratch for that of a packed run
std::filesystem::path energiesOf(const std::filesystem::path& folder,
                                 const std::filesystem::path& scratch) {
    if (formatOf(folder) == RunFormat::Csv) {
        return folder / run_files::kEnergy;
    }
    unpackTables(
        folder / run_files::kTables,
        {.input = scratch / run_files::kInput, .log = {}, .energy = scratch / run_files::kEnergy});
    return scratch / run_files::kEnergy;
}

/// Returns a part in the time of the loop. @throw Error where no tick is in it
RunSpan loopSpan(const RecordedRun& run, const RunSpan& span) {
    if (run.samples.empty()) {
        throw Error("the run has no tick");
    }
    const double begin = run.samples.front().time;
    const RunSpan loop{.from = begin + span.from, .to = begin + span.to};
    const auto isIn = [&loop](const TickSample& sample) {
        return sample.time >= loop.from && sample.time <= loop.to;
    };
    if (std::ranges::none_of(run.samples, isIn)) {
        throw Error(formatted("no tick of the run is in this part: it goes from 0 s to %g s",
                              run.samples.back().time - begin));
    }
    return loop;
}

}  // namespace

void writeSlice(const std::filesystem::path& folder, const LoadedScene& loaded,
                const RecordedRun& run, const RunSpan& part, const std::filesystem::path& target) {
    const RunSpan span = loopSpan(run, part);
    std::optional<Recording> slice;
    TickMemory memory = run.memory;
    ClosestPointTracker tracker;
    for (TickSample sample : run.samples) {
        const bool isIn = sample.time >= span.from && sample.time <= span.to;
        if (isIn && !slice) {
            slice.emplace(RecordingTarget{.folder = target}, loaded, memory, 0.0);
        }
        sample.output = tick(loaded.scene, sample.input, memory, tracker);
        if (isIn) {
            slice->take(sample);
        }
    }
    slice->finish();
    std::filesystem::remove(target / run_files::kEnergy);
    const PrivateFolder scratch;
    const std::filesystem::path energies = energiesOf(folder, scratch.path());
    if (isThere(energies)) {
        copyEnergies(energies, span, target / run_files::kEnergy);
    }
}

}  // namespace asperity
