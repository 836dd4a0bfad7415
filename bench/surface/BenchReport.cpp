#include "bench/surface/BenchReport.h"

#include "core/Units.h"

#include <cstdio>
#include <nlohmann/json.hpp>

namespace asperity {

namespace {

double percent(std::size_t part, std::size_t whole) {
    return whole == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

void printMethod(const MethodResult& method, const MethodResult& ours) {
    std::printf("  %-46s %10.1f %10.0f %7zu %7.2f %% %9.1e %9.2f %8.2f", method.name.c_str(),
                method.median, method.p99, method.wrong, percent(method.wrong, method.queries),
                method.worst / 1.0_nm, method.median / ours.median, method.p99 / ours.p99);
    if (method.certified > 0) {
        std::printf("   certified %.2f %%, of these wrong: %zu",
                    percent(method.certified, method.queries), method.certifiedWrong);
    }
    std::printf("\n");
}

void printWork(const WorkResult& work) {
    std::printf("%s: %zu queries; the reference may be %.1e nm too far\n", work.name.c_str(),
                work.methods.front().queries, work.referenceDoubt / 1.0_nm);
    std::printf("  %-46s %10s %10s %7s %9s %9s %9s %8s\n", "method", "median ns", "p99 ns", "wrong",
                "", "worst nm", "x median", "x p99");
    for (const MethodResult& method : work.methods) {
        printMethod(method, work.methods.front());
        if (method.below > kWrong) {
            std::printf("  ! %s found a point %.1e nm nearer than the reference\n",
                        method.name.c_str(), method.below / 1.0_nm);
        }
    }
    std::printf("\n");
}

void printRandom(const std::vector<RandomResult>& results) {
    std::printf("tips anywhere, no start\n  %-34s %9s %7s %10s %11s %9s %10s %10s %6s\n", "scan",
                "queries", "wrong", "worst nm", "certified", "of these", "restarted", "different",
                "tied");
    for (const RandomResult& r : results) {
        std::printf("  %-34s %9zu %7zu %10.1e %9.2f %% %9zu %10zu %10zu %6zu\n", r.name.c_str(),
                    r.queries, r.wrong, r.worst / 1.0_nm, percent(r.certified, r.queries),
                    r.certifiedWrong, r.restarted, r.different, r.tied);
        if (r.referenceDoubt > kWrong) {
            std::printf("  ! the reference is up to %.1e nm too far\n", r.referenceDoubt / 1.0_nm);
        }
        if (r.below > kWrong) {
            std::printf("  ! a point %.1e nm nearer than the reference was found\n",
                        r.below / 1.0_nm);
        }
    }
    std::printf("\n");
}

void printSize(const SizeResult& size) {
    std::printf("the same slide on %d x %d and on %d x %d pixels: median %.0f and %.0f ns (x %.2f,"
                " target 1), p99 %.0f and %.0f ns (x %.2f)\n\n",
                size.smallPixels, size.smallPixels, size.largePixels, size.largePixels,
                size.onSmall.median, size.onLarge.median, size.onLarge.median / size.onSmall.median,
                size.onSmall.p99, size.onLarge.p99, size.onLarge.p99 / size.onSmall.p99);
}

void printChain(const ChainResult& chain) {
    std::printf(
        "closest point + force + decoupling: median %.0f ns (closest point %.0f), p99 %.0f ns:"
        " x %.1f of its median\n"
        "  CHAI3D's update, recorded elsewhere, not measured here: %.0f and %.0f ns: x %.0f"
        " and x %.0f\n\n",
        chain.time.median, chain.closest.median, chain.time.p99, chain.time.p99 / chain.time.median,
        kRecordedChai3d.median, kRecordedChai3d.p99, kRecordedChai3d.median / chain.time.median,
        kRecordedChai3d.p99 / chain.time.p99);
}

nlohmann::json jsonOf(const MethodResult& m) {
    return {{"name", m.name},
            {"queries", m.queries},
            {"median_ns", m.median},
            {"p99_ns", m.p99},
            {"wrong", m.wrong},
            {"worst_m", m.worst},
            {"below_reference_m", m.below},
            {"certified", m.certified},
            {"certified_wrong", m.certifiedWrong}};
}

nlohmann::json jsonOf(const WorkResult& work) {
    nlohmann::json methods = nlohmann::json::array();
    for (const MethodResult& method : work.methods) {
        methods.push_back(jsonOf(method));
    }
    return {{"name", work.name}, {"reference_doubt_m", work.referenceDoubt}, {"methods", methods}};
}

nlohmann::json jsonOf(const RandomResult& r) {
    return {{"name", r.name},
            {"reference_doubt_m", r.referenceDoubt},
            {"queries", r.queries},
            {"wrong", r.wrong},
            {"worst_m", r.worst},
            {"below_reference_m", r.below},
            {"certified", r.certified},
            {"certified_wrong", r.certifiedWrong},
            {"restarted", r.restarted},
            {"different", r.different},
            {"tied", r.tied}};
}

}  // namespace

void printTables(const BenchResults& results) {
    for (const WorkResult& work : results.works) {
        printWork(work);
    }
    if (!results.random.empty()) {
        printRandom(results.random);
    }
    if (results.size) {
        printSize(*results.size);
    }
    if (results.chain) {
        printChain(*results.chain);
    }
    for (const CopyResult& copy : results.copies) {
        std::printf("machine limit: copy of %d x %d float heights %.3f ms\n", copy.pixels,
                    copy.pixels, copy.time * 1e-6);
    }
    for (const std::string& peer : results.missingPeers) {
        std::printf("%s not installed when this was built (tools/install_peers.sh)\n",
                    peer.c_str());
    }
}

void printJson(const BenchResults& results) {
    nlohmann::json json;
    for (const WorkResult& work : results.works) {
        json["works"].push_back(jsonOf(work));
    }
    for (const RandomResult& random : results.random) {
        json["random"].push_back(jsonOf(random));
    }
    if (results.size) {
        json["size"] = {{"small_pixels", results.size->smallPixels},
                        {"large_pixels", results.size->largePixels},
                        {"on_small", jsonOf(results.size->onSmall)},
                        {"on_large", jsonOf(results.size->onLarge)}};
    }
    if (results.chain) {
        json["chain"] = {{"median_ns", results.chain->time.median},
                         {"p99_ns", results.chain->time.p99},
                         {"closest_point_median_ns", results.chain->closest.median},
                         {"closest_point_p99_ns", results.chain->closest.p99}};
    }
    for (const CopyResult& copy : results.copies) {
        json["copies"].push_back({{"pixels", copy.pixels}, {"time_ns", copy.time}});
    }
    json["missing_peers"] = results.missingPeers;
    std::printf("%s\n", json.dump(2).c_str());
}

}  // namespace asperity
