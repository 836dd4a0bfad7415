#include "app/recording/RunPlayback.h"

#include "app/recording/Replay.h"
#include "app/recording/RunPacking.h"
#include "app/runs/RunFolder.h"
#include "core/Error.h"
#include "core/TemporaryFile.h"
#include "core/io/recording/PackedTables.h"
#include "core/io/recording/TickLog.h"

#include <algorithm>
#include <fstream>

namespace asperity {

namespace {

/// Passes a table's rows to `take`, some at a time, as tables of their own whose line numbers are
/// those of the file. @param isWhole false: what follows the last whole line does not count
void readPieces(const std::filesystem::path& path, bool isWhole,
                const std::function<void(const CsvTable&)>& take) {
    constexpr std::size_t kLines = 20'000;
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        throw InputError(path.string(), "", "cannot be read");
    }
    std::string head;  // comments and names of columns
    std::string line;
    std::size_t before = 0;  // lines
    bool isNamed = false;
    while (!isNamed && std::getline(file, line)) {
        head += line + '\n';
        ++before;
        isNamed = !line.empty() && line.front() != '#' && line != "\r";
    }
    if (!isNamed && !isWhole) {
        throw InputError(path.string(), "", "the recording was cut off before its first tick");
    }
    const std::size_t headLines = before;
    do {
        std::string rows;
        std::size_t lines = 0;
        while (lines < kLines && std::getline(file, line)) {
            rows += line;
            rows += file.eof() ? "" : "\n";  // else a last line would seem whole
            ++lines;
        }
        const std::string_view kept = isWhole ? std::string_view(rows) : wholeLines(rows);
        take(CsvTable(head + std::string(before - headLines, '\n') + std::string(kept),
                      path.string()));
        before += lines;
    } while (file);
}

}  // namespace

void RunInputs::add(const TickSample& sample) {
    const TickInput& input = sample.input;
    if (settings_.empty() || settings_.back() != input.settings) {
        settings_.push_back(input.settings);
    }
    begin_ = inputs_.empty() ? sample.time : begin_;
    shortestStep_ = inputs_.empty() ? input.timeStep : std::min(shortestStep_, input.timeStep);
    inputs_.push_back({.time = sample.time - begin_,
                       .device = input.device,
                       .measurement = input.measurement,
                       .timeStep = input.timeStep,
                       .starts = input.starts,
                       .settings = static_cast<std::uint32_t>(settings_.size() - 1)});
}

void RunInputs::shorten(std::size_t size) { inputs_.resize(std::min(size, inputs_.size())); }

TickInput RunInputs::input(std::size_t tick) const {
    const Input& input = inputs_.at(tick);
    return {.device = input.device,
            .measurement = input.measurement,
            .settings = settings_[input.settings],
            .timeStep = input.timeStep,
            .starts = input.starts};
}

std::size_t RunInputs::firstAfter(double time) const {
    return static_cast<std::size_t>(std::ranges::upper_bound(inputs_, time, {}, &Input::time) -
                                    inputs_.begin());
}

RunInputs inputsOf(const BlackBox& box) {
    RunInputs inputs(box.memory());
    for (const TickSample& sample : box.samples()) {
        inputs.add(sample);
    }
    return inputs;
}

std::optional<std::size_t> lastJump(const BlackBox& box) {
    const auto branch = [&box](std::size_t tick) {
        return box.samples()[tick].output.model.contact.branch;
    };
    for (std::size_t tick = box.samples().size(); tick-- > 1;) {
        if (branch(tick) != branch(tick - 1)) {
            return tick;
        }
    }
    return std::nullopt;
}

namespace {

void addAll(RunInputs& inputs, const std::filesystem::path& table, bool isWhole) {
    readPieces(table, isWhole, [&inputs](const CsvTable& rows) {
        for (const TickSample& sample : readTickInputs(rows)) {
            inputs.add(sample);
        }
    });
}

void addPacked(RunInputs& inputs, const std::filesystem::path& folder) {
    const PrivateFolder scratch;
    const TextTables text{.input = scratch.path() / run_files::kInput,
                          .log = {},
                          .energy = scratch.path() / run_files::kEnergy};
    unpackTables(folder / run_files::kTables, text);
    addAll(inputs, text.input, true);
}

}  // namespace

RunOnDisk readRunInputs(const std::filesystem::path& folder) {
    const RunState state = stateOf(folder);
    const bool isWhole = state == RunState::Complete;
    RunOnDisk run{
        .state = state, .scan = scanRecord(folder), .inputs = RunInputs(startMemory(folder))};
    if (formatOf(folder) == RunFormat::Hdf5) {
        addPacked(run.inputs, folder);
        return run;
    }
    addAll(run.inputs, folder / run_files::kInput, isWhole);
    if (!isWhole) {
        std::size_t logged = 0;
        readPieces(folder / run_files::kLog, isWhole,
                   [&logged](const CsvTable& table) { logged += table.rows(); });
        run.inputs.shorten(logged);
    }
    return run;
}

RunPlayback::RunPlayback(Unchecked /*tag*/, const Scene& scene, RunInputs inputs)
    : scene_(&scene)
    , inputs_(std::move(inputs))
    , checkpoints_({inputs_.memory()})
    , memory_(inputs_.memory()) {}

RunPlayback::RunPlayback(const Scene& scene, const BlackBox& box)
    : RunPlayback(Unchecked(), scene, inputsOf(box)) {}

RunPlayback::RunPlayback(const Scene& scene, RunInputs inputs)
    : RunPlayback(Unchecked(), scene, std::move(inputs)) {
    if (inputs_.size() == 0) {
        throw Error("the run was cut off before its first tick: there is nothing to show");
    }
    requireSameSettings(scene, inputs_.input(0), inputs_.shortestStep());
}

std::size_t RunPlayback::tickAt(double time) const {
    const std::size_t after = inputs_.firstAfter(time + kTimeRounding);
    return after == 0 ? 0 : after - 1;
}

const TickSample& RunPlayback::at(std::size_t tick) {
    seek(tick);
    return sample_;
}

void RunPlayback::play(std::size_t first, const std::function<bool(const TickSample&)>& sink,
                       Progress* progress) {
    for (std::size_t tick = first; tick < size(); ++tick) {
        if ((tick - first) % kCheckpointTicks == 0) {
            reportTo(progress,
                     static_cast<double>(tick - first) / static_cast<double>(size() - first));
        }
        if (!sink(at(tick))) {
            return;
        }
    }
}

/// Until `tick` is the one before next_.
void RunPlayback::seek(std::size_t tick) {
    if (next_ == tick + 1) {
        return;
    }
    const std::size_t checkpoint =
        std::min(tick / kCheckpointTicks, checkpoints_.size() - 1) * kCheckpointTicks;
    if (next_ > tick || next_ < checkpoint) {
        next_ = checkpoint;
        memory_ = checkpoints_[checkpoint / kCheckpointTicks];
    }
    while (next_ <= tick) {
        step();
    }
}

void RunPlayback::step() {
    sample_.time = inputs_.time(next_);
    sample_.input = inputs_.input(next_);
    sample_.output = tick(*scene_, sample_.input, memory_, tracker_);
    ++next_;
    if (next_ % kCheckpointTicks == 0 && checkpoints_.size() == next_ / kCheckpointTicks) {
        checkpoints_.push_back(memory_);
    }
}

}  // namespace asperity
