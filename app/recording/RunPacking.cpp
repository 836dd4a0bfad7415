#include "app/recording/RunPacking.h"

#include "app/recording/Replay.h"
#include "app/runs/RunFolder.h"
#include "core/Error.h"
#include "core/io/recording/PackedTables.h"

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

}  // namespace asperity
