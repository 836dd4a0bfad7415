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

constexpr int kRounds = 7;
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
    for (int round = 0; round < kRounds; ++round) {
        pair.ours.run();
        answers = answers && pair.gwyddion.tryRun();
    }
}

/// @return whether Gwyddion was faster
bool print(const Pair& pair) {
    constexpr double kMilliseconds = 1e-6;
    std::printf("%-42s %9.2f", pair.name.c_str(), pair.ours.time * kMilliseconds);
    if (!std::isfinite(pair.gwyddion.time)) {
        std::printf("  not read by Gwyddion\n");
        return false;
    }
    const double ratio = pair.gwyddion.time / pair.ours.time;
    std::printf(" %9.2f %7.1f%s\n", pair.gwyddion.time * kMilliseconds, ratio,
                ratio < 1.0 ? "  slower than Gwyddion" : "");
    return ratio < 1.0;
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
                "looked at; Gwyddion by its own\nmodules, which are loaded before. Fresh "
                "processes, warm cache, best of %d [ms]\n%-42s %9s %9s %7s\n",
                kRounds, "file", "ours", "Gwyddion", "ratio");
    int slower = 0;
    for (Pair& pair : pairs) {
        measure(pair);
        slower += print(pair) ? 1 : 0;
    }
    std::printf("slower than Gwyddion: %d of %zu\n", slower, pairs.size());
}

}  // namespace asperity
