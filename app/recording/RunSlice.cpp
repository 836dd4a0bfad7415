#include "app/recording/RunSlice.h"

#include "app/recording/Recording.h"
#include "app/recording/RunPacking.h"
#include "app/runs/RunFolder.h"
#include "core/Error.h"
#include "core/FormattedText.h"
#include "core/PrivateFolder.h"
#include "core/io/TextValue.h"
#include "core/io/recording/PackedTables.h"
#include "core/io/tables/CsvRows.h"
#include "core/io/tables/CsvWriter.h"

#include <algorithm>
#include <optional>

namespace asperity {

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

/// Where the trace is text. @param scratch for that of a packed run
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

void requireTicks(const RecordedRun& run, const RunSpan& span) {
    const auto isIn = [&span](const TickSample& sample) {
        return sample.time >= span.from && sample.time <= span.to;
    };
    if (std::ranges::none_of(run.samples, isIn)) {
        throw Error(run.samples.empty()
                        ? std::string("the run has no tick")
                        : formatted("no tick of the run is in this part: it goes from %g s to %g s",
                                    run.samples.front().time, run.samples.back().time));
    }
}

}  // namespace

void writeSlice(const std::filesystem::path& folder, const LoadedScene& loaded,
                const RecordedRun& run, const RunSpan& span, const std::filesystem::path& target) {
    requireTicks(run, span);
    std::optional<Recording> slice;
    TickMemory memory = run.memory;
    ClosestPointTracker tracker;
    for (TickSample sample : run.samples) {
        const bool isIn = sample.time >= span.from && sample.time <= span.to;
        if (isIn && !slice) {
            slice.emplace(RecordingPlace{.folder = target}, loaded, memory, 0.0);
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
