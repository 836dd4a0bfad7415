#include "app/recording/Replay.h"

#include "app/runs/RunFolder.h"
#include "core/Error.h"
#include "core/SiFormat.h"
#include "core/io/FormerKeys.h"
#include "core/io/TextValue.h"
#include "core/io/heightmap/ScanFile.h"
#include "core/io/recording/RowChecks.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace asperity {

namespace {

/// A program that learns to judge more sets flags where an earlier one set none; no other column
/// depends on them.
constexpr const char* kFlags = "flags";

/// Returns whether a recorded cell holds what is replayed; the words of flags may be former ones.
bool isSameCell(const std::string& column, std::string_view before, std::string_view now) {
    return before == now || (column == kFlags && currentFlags(before) == now);
}

/// Returns whether two numbers are the same in single precision.
bool isSameSingle(std::string_view before, std::string_view now) {
    const std::optional<double> one = parseNumber(before);
    const std::optional<double> other = parseNumber(now);
    return one && other &&
           (static_cast<float>(*one) == static_cast<float>(*other) ||
            (std::isnan(*one) && std::isnan(*other)));
}

/// A log of ours, however old, has no others. @throw InputError
void requireKnownColumns(const CsvTable& recorded, const CsvTable& replayed) {
    for (const std::string& column : recorded.columns()) {
        if (!replayed.has(column)) {
            throw InputError(recorded.file(), "column " + column,
                             "is no column of a force log: expected those that a recording writes");
        }
    }
}

/// Compares the digits that a log in single precision lacks by their check sums; flags count as
/// they were recorded. @throw Error naming the ticks
void requireSameChecks(const RecordedRun& run, const CsvTable& replayed) {
    RowChecks checks;
    for (std::size_t row = 0; row < run.log.rows(); ++row) {
        for (const std::string& column : run.log.columns()) {
            checks.add((column == kFlags ? run.log : replayed).view(row, column));
        }
        checks.endRow();
    }
    const std::vector<std::uint32_t> now = checks.checks();
    const auto differing = std::ranges::mismatch(run.logChecks, now).in1;
    if (differing != run.logChecks.end()) {
        const auto first = static_cast<std::size_t>(differing - run.logChecks.begin());
        throw Error("first differing tick: one of " + std::to_string(RowChecks::kRows) + " from " +
                    std::to_string(first * RowChecks::kRows) +
                    " on: a number of the log differs in digits beyond single precision");
    }
}

}  // namespace

void requireSameSettings(const Scene& scene, const TickInput& first, double shortestStep) {
    const auto require = [](const std::string& key, double ofScene, double ofInput) {
        if (ofScene != ofInput) {
            throw Error("first differing tick: 0: " + key + " is " + exactText(ofScene) +
                        " in scene.toml, " + exactText(ofInput) + " in tick_input.csv");
        }
    };
    require("time step (1 / rate_hz)", scene.timeStep(), shortestStep);
    require("position_gain", scene.settings.positionGain, first.settings.positionGain);
    require("force_gain", scene.settings.forceGain, first.settings.forceGain);
    require("position_control", static_cast<double>(scene.settings.positionControl),
            static_cast<double>(first.settings.positionControl));
    require("correction_hz", scene.settings.correctionBandwidth,
            first.settings.correctionBandwidth);
}

namespace {

Vector2 sizeOf(const LoadedScene& loaded) {
    return {loaded.scene.surface.sizeX(), loaded.scene.surface.sizeY()};
}

std::string sizeText(const Vector2& size) {
    return formatSi(size.x(), "m") + " x " + formatSi(size.y(), "m");
}

/// Returns the size of the whole scan that a scene shows a part of [m].
Vector2 scanSizeOf(const SampleDescription& sample) {
    const ScanFile file(sample.file, sample.scale);
    const HeightMap& map = heightChannel(file.contents(), sample.file, sample.channel).map;
    return {map.sizeX(), map.sizeY()};
}

/// But for the last digits of a sum.
bool isSameSize(const Vector2& one, const Vector2& other) {
    constexpr double kRounding = 1e-12;
    return ((one - other).cwiseAbs().array() <= kRounding * one.cwiseAbs().array()).all();
}

/// Returns the size of the whole scan where a correction of a reader may have changed it [m].
std::optional<Vector2> correctedSize(const LoadedScene& loaded) {
    constexpr std::string_view kCorrected = "NanoScope";
    const SampleDescription& sample = loaded.scene.description.sample;
    if (loaded.format.find(kCorrected) == std::string::npos || sample.scale.hasSize()) {
        return std::nullopt;
    }
    const Vector2 size = scanSizeOf(sample);
    return isSameSize(size, {size.x(), size.x()}) ? std::nullopt : std::optional(size);
}

/// Returns why a scan is read with another size than before, for the end of a sentence; empty: it
/// is not known.
std::string causeOfSize(const LoadedScene& loaded) {
    if (loaded.scene.description.sample.scale.hasSize()) {
        return ", by the size in scene.toml";
    }
    return correctedSize(loaded) ? ", after a correction of the reader" : "";
}

}  // namespace

void requireSameScan(const LoadedScene& loaded, const ScanRecord& recorded) {
    const std::string& file = loaded.scene.description.sample.file;
    if (loaded.sha256 != recorded.sha256) {
        throw InputError(file, "",
                         "the scan has changed since the run was recorded (its hash differs)");
    }
    const Vector2 now = sizeOf(loaded);
    if (!loaded.sha256.empty() && recorded.size && !isSameSize(*recorded.size, now)) {
        throw InputError(file, "",
                         "it was read as " + sizeText(*recorded.size) +
                             " when the run was recorded, " + "and is now read as " +
                             sizeText(now) + causeOfSize(loaded) +
                             ": the run does not replay; record it again");
    }
}

std::string correctionOfScan(const LoadedScene& loaded, const ScanRecord& recorded) {
    if (recorded.size) {
        return {};
    }
    const std::optional<Vector2> size = correctedSize(loaded);
    return size ? "the size along y of NanoScope scans that are not square has been corrected; the "
                  "scan is now read as " +
                      sizeText(*size) + ", and a run recorded before that does not replay"
                : std::string();
}

std::string failureOfReplay(const std::string& difference, const LoadedScene& loaded,
                            const ScanRecord& recorded) {
    const std::string correction = correctionOfScan(loaded, recorded);
    return correction.empty()
               ? difference
               : loaded.scene.description.sample.file + ": " + correction + " (" + difference + ")";
}

void replayTicks(const Scene& scene, const RecordedRun& run, const TickSink& sink) {
    if (!run.samples.empty()) {
        const auto shortest = std::ranges::min_element(
            run.samples, {}, [](const TickSample& sample) { return sample.input.timeStep; });
        requireSameSettings(scene, run.samples.front().input, shortest->input.timeStep);
    }
    TickMemory memory = run.memory;
    ClosestPointTracker tracker;
    for (TickSample sample : run.samples) {
        sample.output = tick(scene, sample.input, memory, tracker);
        sink(sample);
    }
}

CsvTable replay(const Scene& scene, const RecordedRun& run, const std::filesystem::path& out,
                const TickSink& sink) {
    RunRecorder recorder(out, scene.belief.field);
    replayTicks(scene, run, [&](const TickSample& sample) {
        recorder.take(sample);
        if (sink) {
            sink(sample);
        }
    });
    recorder.close();
    return readCsv(out / run_files::kLog);
}

void requireSameLog(const RecordedRun& run, const CsvTable& replayed) {
    const CsvTable& recorded = run.log;
    requireKnownColumns(recorded, replayed);
    const bool isExact = run.logChecks.empty();
    const std::size_t common = std::min(recorded.rows(), replayed.rows());
    std::string otherFlags;
    for (std::size_t row = 0; row < common; ++row) {
        for (const std::string& column : recorded.columns()) {
            const std::string_view before = recorded.view(row, column);
            const std::string_view now = replayed.view(row, column);
            if (isSameCell(column, before, now) || (!isExact && isSameSingle(before, now))) {
                continue;
            }
            const std::string difference = "first differing tick: " + std::to_string(row) +
                                           " (time " + replayed.text(row, "time_s") +
                                           " s): " + column + " was " + std::string(before) +
                                           ", is now " + std::string(now);
            if (column != kFlags) {
                throw Error(difference);
            }
            otherFlags = otherFlags.empty() ? difference : otherFlags;
        }
    }
    if (run.state == RunState::Complete && recorded.rows() != replayed.rows()) {
        throw Error("first differing tick: " + std::to_string(common) + ": the recorded log has " +
                    std::to_string(recorded.rows()) + " ticks, the recorded input " +
                    std::to_string(replayed.rows()));
    }
    if (!isExact) {
        requireSameChecks(run, replayed);
    }
    if (!otherFlags.empty()) {
        throw Error("bit-identical but for flags: " + std::to_string(common) + " ticks; " +
                    otherFlags);
    }
}

std::string differenceOnReplay(const Scene& scene, const RecordedRun& run,
                               const std::filesystem::path& scratch, const TickSink& sink,
                               Progress* progress) {
    constexpr std::size_t kReports = 50;
    const std::size_t each = run.samples.size() / kReports + 1;
    std::size_t done = 0;
    std::filesystem::create_directory(scratch);
    const CsvTable log = replay(scene, run, scratch, [&](const TickSample& sample) {
        if (done % each == 0) {
            reportTo(progress, static_cast<double>(done) / static_cast<double>(run.samples.size()));
        }
        ++done;
        if (sink) {
            sink(sample);
        }
    });
    std::filesystem::remove_all(scratch);
    try {
        requireSameLog(run, log);
    } catch (const Error& difference) {
        return difference.what();
    }
    return {};
}

}  // namespace asperity
