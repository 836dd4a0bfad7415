#include "app/recording/Replay.h"

#include "app/runs/RunFolder.h"
#include "core/Error.h"
#include "core/io/TextValue.h"

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

namespace asperity {

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

void replayTicks(const Scene& scene, const RecordedRun& run, const TickSink& sink) {
    if (!run.samples.empty()) {
        const auto shortest = std::ranges::min_element(
            run.samples, {}, [](const TickSample& sample) { return sample.input.timeStep; });
        requireSameSettings(scene, run.samples.front().input, shortest->input.timeStep);
    }
    TickMemory memory = run.memory;
    for (TickSample sample : run.samples) {
        sample.output = tick(scene, sample.input, memory);
        sink(sample);
    }
}

CsvTable replay(const Scene& scene, const RecordedRun& run, const std::filesystem::path& out) {
    RunRecorder recorder(out);
    replayTicks(scene, run, [&recorder](const TickSample& sample) { recorder.take(sample); });
    recorder.close();
    return readCsv(out / run_files::kLog);
}

void requireSameLog(const RecordedRun& run, const CsvTable& replayed) {
    const CsvTable& recorded = run.log;
    const std::size_t common = std::min(recorded.rows(), replayed.rows());
    for (std::size_t row = 0; row < common; ++row) {
        for (const std::string& column : recorded.columns()) {
            const std::string& before = recorded.text(row, column);
            const std::string& now = replayed.text(row, column);
            if (before != now) {
                std::ostringstream difference;
                difference << "first differing tick: " << row << " (time "
                           << replayed.text(row, "time_s") << " s): " << column << " was " << before
                           << ", is now " << now;
                throw Error(difference.str());
            }
        }
    }
    if (run.state == RunState::Complete && recorded.rows() != replayed.rows()) {
        throw Error("first differing tick: " + std::to_string(common) + ": the recorded log has " +
                    std::to_string(recorded.rows()) + " ticks, the recorded input " +
                    std::to_string(replayed.rows()));
    }
}

}  // namespace asperity
