#include "app/reports/LoopReport.h"

#include "app/program/JsonText.h"
#include "core/SiFormat.h"
#include "core/Version.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

namespace asperity {

namespace {

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace

struct AlternatingBlocks::BareLoop {
    explicit BareLoop(double rate)
        : thread(std::in_place, rate, [this](const Beat& beat) {
            lateness.add(beat.lateness);
            skipped += beat.skipped;
        }) {}

    LatencyHistogram lateness;
    long skipped = 0;
    std::optional<PacedThread> thread;
};

AlternatingBlocks::AlternatingBlocks(HapticLoop& loop, double rate) : loop_(loop), rate_(rate) {
    beginOwn();
}

AlternatingBlocks::~AlternatingBlocks() { loop_.stop(); }

bool AlternatingBlocks::blockIsOver() const { return monotonicSeconds() - blockBegin_ >= kBlock; }

void AlternatingBlocks::beginOwn() {
    loop_.start();
    blockBegin_ = monotonicSeconds();
}

void AlternatingBlocks::beginBare() {
    running_ = std::make_unique<BareLoop>(rate_);
    blockBegin_ = monotonicSeconds();
}

void AlternatingBlocks::endOwn() {
    loop_.stop();
    ownP99_.push_back(loop_.times().lateness.quantile(0.99));
    own_.tick.add(loop_.times().tick);
    own_.lateness.add(loop_.times().lateness);
}

void AlternatingBlocks::endBare() {
    running_->thread.reset();
    bareP99_.push_back(running_->lateness.quantile(0.99));
    bare_.add(running_->lateness);
    bareSkipped_ += running_->skipped;
    running_.reset();
}

void AlternatingBlocks::poll() {
    if (!blockIsOver()) {
        return;
    }
    if (running_) {
        endBare();
        beginOwn();
    } else {
        endOwn();
        beginBare();
    }
}

void AlternatingBlocks::finish() {
    loop_.stop();
    running_.reset();
    ownP99_.resize(bareP99_.size());
}

double AlternatingBlocks::medianP99Ratio() const {
    return pairs() == 0
               ? 0.0
               : median({ownP99_.begin(), ownP99_.begin() + static_cast<std::ptrdiff_t>(pairs())}) /
                     median(bareP99_);
}

namespace {

nlohmann::ordered_json quantilesJson(const LatencyHistogram& times) {
    const LatencyQuantiles quantiles = times.quantiles();
    return {
        {"p50_s", quantiles.median}, {"p99_s", quantiles.p99}, {"largest_s", quantiles.largest}};
}

std::string quantilesText(const LatencyHistogram& times) {
    const LatencyQuantiles quantiles = times.quantiles();
    return "p50 " + formatSi(quantiles.median, "s") + ", p99 " + formatSi(quantiles.p99, "s") +
           ", maximum " + formatSi(quantiles.largest, "s");
}

/// Returns the time for one tick [s]: the thread that fetches it passes it on, too.
double recordingTime(const LoopReport& report) { return report.fetchTime + report.writingTime; }

nlohmann::ordered_json costJson(double perTick, double rate) {
    return {{"time_per_tick_s", perTick}, {"share_of_period", perTick * rate}};
}

std::string costText(double perTick, double rate) {
    std::ostringstream text;
    text << formatSi(perTick, "s") << " a tick, " << 100.0 * perTick * rate << " % of the period";
    return text.str();
}

}  // namespace

std::string loopReportJson(const LoopReport& report) {
    const AlternatingBlocks& blocks = report.blocks;
    nlohmann::ordered_json json{{"version", kVersion},
                                {"rate_hz", report.rate},
                                {"duration_s", report.duration},
                                {"elapsed_s", report.elapsed},
                                {"block_s", AlternatingBlocks::kBlock},
                                {"scheduling", keyOf(report.statistics.policy)},
                                {"ticks", report.statistics.ticks},
                                {"overruns", report.statistics.overruns},
                                {"tick_time", quantilesJson(blocks.own().tick)},
                                {"lateness", quantilesJson(blocks.own().lateness)},
                                {"bare_loop",
                                 {{"ticks", blocks.bare().count()},
                                  {"overruns", blocks.bareSkipped()},
                                  {"lateness", quantilesJson(blocks.bare())}}},
                                {"pairs_of_blocks", blocks.pairs()},
                                {"median_block_p99_lateness_ratio", blocks.medianP99Ratio()}};
    json["black_box"] = costJson(report.fetchTime, report.rate);
    if (report.writingTime > 0.0) {
        json["recording"] = costJson(recordingTime(report), report.rate);
    }
    for (const ViewRate& view : report.views) {
        json["frames_per_second"][view.view] = view.framesPerSecond;
    }
    return jsonText(json);
}

std::string loopReportText(const LoopReport& report) {
    const AlternatingBlocks& blocks = report.blocks;
    std::ostringstream text;
    text << report.statistics.ticks << " ticks at " << report.rate << " Hz, scheduling "
         << keyOf(report.statistics.policy)
         << (report.statistics.policy == SchedulingPolicy::Ordinary
                 ? " (SCHED_FIFO is not permitted to this user)"
                 : "")
         << "\nduration       " << formatSi(report.elapsed, "s")
         << ": the loop and a bare loop in turn, " << formatSi(AlternatingBlocks::kBlock, "s")
         << " each; ticks are those of the loop"
         << "\ntick time      " << quantilesText(blocks.own().tick) << "\nlateness       "
         << quantilesText(blocks.own().lateness) << "\nbare loop      "
         << quantilesText(blocks.bare()) << "\noverruns       " << report.statistics.overruns
         << ", bare loop " << blocks.bareSkipped();
    if (blocks.pairs() > 0) {
        text << "\nlateness ratio " << blocks.medianP99Ratio()
             << " (median p99 of 1 s blocks over that of the bare loop, " << blocks.pairs()
             << " pairs)";
    }
    text << "\nblack box      " << costText(report.fetchTime, report.rate);
    if (report.writingTime > 0.0) {
        text << "\nrecording      " << costText(recordingTime(report), report.rate);
    }
    for (const ViewRate& view : report.views) {
        text << "\n" << view.view << ": " << view.framesPerSecond << " frames/s";
    }
    return text.str();
}

}  // namespace asperity
