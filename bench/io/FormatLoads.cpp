#include "bench/io/FormatLoads.h"

#include "bench/Hills.h"
#include "bench/io/Load.h"
#include "core/io/heightmap/HeightMapWriter.h"
#include "tests/core/io/heightmap/RealScans.h"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

namespace asperity {

namespace {

constexpr int kFormatRounds = 7;
constexpr int kImagePixels = 2048;
constexpr int kTextPixels = 1024;

/// One file, read by both.
struct Pair {
    std::string name;
    Load ours;
    Load gwyddion;
};

Pair pairOf(const std::string& name, const std::filesystem::path& file) {
    Pair pair{.name = name, .ours = {.command = ownCommand("all", file)}};
#ifdef ASPERITY_GWYDDION_READ
    pair.gwyddion.command = quoted(ASPERITY_GWYDDION_READ) + " " + quoted(file) + " 2>&-";
#endif
    return pair;
}

/// One after the other in each round, so that both meet the same machine.
void measure(Pair& pair) {
    bool answers = !pair.gwyddion.command.empty();
    for (int round = 0; round < kFormatRounds; ++round) {
        pair.ours.run();
        answers = answers && pair.gwyddion.tryRun();
    }
}

/// Files that Gwyddion reads faster.
struct Slower {
    int loads = 0;      ///< without the start of the program
    int processes = 0;  ///< with it
};

void print(const Pair& pair, Slower& slower) {
    constexpr double kMilliseconds = 1e-6;
    const Load& ours = pair.ours;
    const Load& theirs = pair.gwyddion;
    std::printf("%-42s %7.2f", pair.name.c_str(), ours.time * kMilliseconds);
    if (!std::isfinite(theirs.time)) {
        std::printf(" %9s %6s %7.1f\n", "not read", "", ours.whole * kMilliseconds);
        return;
    }
    std::printf(" %9.2f %6.1f %7.1f %9.1f %6.1f\n", theirs.time * kMilliseconds,
                theirs.time / ours.time, ours.whole * kMilliseconds, theirs.whole * kMilliseconds,
                theirs.whole / ours.whole);
    slower.loads += theirs.time < ours.time ? 1 : 0;
    slower.processes += theirs.whole < ours.whole ? 1 : 0;
}

void writePoints(const std::filesystem::path& path, const HeightMap& map) {
    std::ofstream stream(path);
    stream << "X[nm] Y[nm] Z[nm]\n";
    constexpr double kNanometers = 1e9;
    for (int row = 0; row < map.rows; ++row) {
        for (int column = 0; column < map.columns; ++column) {
            stream << column << ' ' << row << ' ' << map.at(row, column) * kNanometers << '\n';
        }
    }
    if (!stream.flush()) {
        throw Error(path.string() + ": cannot be written");
    }
}

/// Large files, written here.
std::vector<Pair> largeFiles(const BenchFolder& folder) {
    std::vector<Pair> pairs;
    const auto add = [&](const char* name, int pixels, const auto& write) {
        write(folder.file(name), hills<HeightMap>(pixels));
        pairs.push_back(pairOf(name + (", " + std::to_string(pixels)) + " x " +
                                   std::to_string(pixels) + " pixels",
                               folder.file(name)));
    };
    const auto asExtensionSays = [](const std::filesystem::path& path, const HeightMap& map) {
        writeHeightMap(path, map, {});
    };
    for (const char* name : {"image.gwy", "image.gsf", "image.png", "image.tif", "image.exr"}) {
        add(name, kImagePixels, asExtensionSays);
    }
    add("matrix.txt", kTextPixels, asExtensionSays);
    add("points.xyz", kTextPixels, writePoints);
    return pairs;
}

}  // namespace

void measureFormats(const std::filesystem::path& folder) {
    const BenchFolder written;
    std::vector<Pair> pairs;
    for (const std::string& file : test::realScans()) {
        pairs.push_back(pairOf(file, folder / file));
    }
    for (Pair& pair : largeFiles(written)) {
        pairs.push_back(std::move(pair));
    }
    std::printf("All images of a file, from its name to double precision in memory, every pixel "
                "looked at, in a fresh process\neach, from a warm cache, best of %d [ms]: the load "
                "alone (Gwyddion's modules are loaded before), and the whole\nprocess from start "
                "to end; ratios are Gwyddion's time over ours\n%-42s %7s %9s %6s %7s %9s %6s\n",
                kFormatRounds, "file", "load", "Gwyddion", "ratio", "process", "Gwyddion", "ratio");
    Slower slower;
    for (Pair& pair : pairs) {
        measure(pair);
        print(pair, slower);
    }
    std::printf("slower than Gwyddion: %d loads and %d processes of %zu\n", slower.loads,
                slower.processes, pairs.size());
}

}  // namespace asperity
