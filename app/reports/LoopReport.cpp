#include "app/reports/LoopReport.h"

#include "app/program/JsonText.h"
#include "core/SiFormat.h"
#include "core/Version.h"

#include <nlohmann/json.hpp>
#include <sstream>

namespace asperity {

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

/// Of one tick [s]: what fetches it hands it over, too.
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
