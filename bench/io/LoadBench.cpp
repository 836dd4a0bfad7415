// Loading a large scan beside a raw read and Gwyddion, from a warm cache, each load in a fresh
// process in which every pixel is looked at:
//   asperity_load_bench                       8192 x 8192 pixels
//   asperity_load_bench formats FOLDER        the files of every format, in ../shared/data/afm
//   asperity_load_bench raw|ours|all|exr FILE one load: time [ns] and sum of the heights [m]
#include "bench/BenchMain.h"
#include "bench/BenchRows.h"
#include "bench/Hills.h"
#include "bench/io/FormatLoads.h"
#include "bench/io/Load.h"
#include "bench/io/LoadAnswer.h"
#include "core/Error.h"
#include "core/TemporaryFile.h"
#include "core/io/heightmap/HeightMapWriter.h"
#include "core/io/heightmap/ScanFile.h"

#include <CLI/CLI.hpp>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unistd.h>
#include <vector>

namespace asperity {

namespace {

constexpr int kLoadRounds = 15;
constexpr int kPixels = 8192;
constexpr int kQuickPixels = 4096;
constexpr int kExrPixels = 4096;
constexpr const char* kByGwyddion = ".gwy by Gwyddion";

// One load of a file, in this process.

/// The least that any reader does: the file's bytes, as they are, into memory of large pages.
void loadRaw(const std::string& file) {
    const auto begin = std::chrono::steady_clock::now();
    PixelVector<float> pixels(std::filesystem::file_size(file) / sizeof(float));
    const std::span<std::byte> bytes = std::as_writable_bytes(std::span(pixels));
    const int descriptor = open(file.c_str(), O_RDONLY | O_CLOEXEC);
    std::size_t done = 0;
    while (done < bytes.size()) {
        const ssize_t count = read(descriptor, bytes.data() + done, bytes.size() - done);
        if (count <= 0) {
            throw Error(file + ": cannot be read");
        }
        done += static_cast<std::size_t>(count);
    }
    close(descriptor);
    printLoad(begin, sumOf(pixels.data(), pixels.size()));
}

void loadOurs(const std::string& file) {
    const auto begin = std::chrono::steady_clock::now();
    const HeightScan scan = readHeightScan(file, "");
    const PixelVector<float>& heights = scan.map.heights;
    const double datum = scan.map.datum * static_cast<double>(heights.size());
    printLoad(begin, datum + sumOf(heights.data(), heights.size()));
}

/// Every image, whatever it shows.
void loadAll(const std::string& file) {
    const auto begin = std::chrono::steady_clock::now();
    double sum = 0.0;
    for (const ScanChannel& channel : readHeightMapFile(file, {}).channels) {
        sum += sumOf(channel.map.heights.data(), channel.map.heights.size());
    }
    printLoad(begin, sum);
}

void loadExr(const std::string& file) {
    const auto begin = std::chrono::steady_clock::now();
    Imf::InputFile image(file.c_str());
    const Imath::Box2i window = image.header().dataWindow();
    const auto columns = static_cast<std::size_t>(window.max.x - window.min.x + 1);
    const auto rows = static_cast<std::size_t>(window.max.y - window.min.y + 1);
    PixelVector<float> pixels(columns * rows);
    Imf::FrameBuffer frame;
    frame.insert("Y", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(pixels.data()), sizeof(float),
                                 sizeof(float) * columns));
    image.setFrameBuffer(frame);
    image.readPixels(window.min.y, window.max.y);
    printLoad(begin, sumOf(pixels.data(), pixels.size()));
}

// All loads, each in a process of its own.

void writeRaw(const std::filesystem::path& path, const HeightMap& map) {
    const std::vector<float> pixels(map.heights.begin(), map.heights.end());
    std::ofstream stream(path, std::ios::binary);
    stream.write(reinterpret_cast<const char*>(pixels.data()),
                 static_cast<std::streamsize>(pixels.size() * sizeof(float)));
    if (!stream.flush()) {
        throw Error(path.string() + ": cannot be written");
    }
}

/// One after the other in each round, so that all meet the same machine.
void measure(std::vector<Load>& loads) {
    for (int round = 0; round < kLoadRounds; ++round) {
        for (Load& load : loads) {
            load.run();
        }
    }
}

/// Heights differ by single precision at most.
void requireSameSums(const std::vector<Load>& loads, double pixels) {
    for (const Load& load : loads) {
        if (std::abs(load.sum - loads.front().sum) > 1e-15 * pixels) {
            throw Error(load.name + " gives other heights than " + loads.front().name);
        }
    }
}

void print(const std::vector<Load>& loads) {
    for (const Load& load : loads) {
        std::printf("  %-28s %8.1f ms\n", load.name.c_str(), load.time * 1e-6);
    }
}

/// Returns the load of this name; none without it.
std::optional<double> timeOf(const std::vector<Load>& loads, std::string_view name) {
    const auto found = std::ranges::find(loads, name, &Load::name);
    return found == loads.end() ? std::nullopt : std::optional(found->time);
}

void measureScan(const BenchFolder& folder, const BenchOptions& options) {
    const int pixels = options.quick ? kQuickPixels : kPixels;
    {
        const HeightMap map = hills<HeightMap>(pixels);
        writeRaw(folder.file("map.raw"), map);
        writeHeightMap(folder.file("map.gsf"), map, {});
        writeHeightMap(folder.file("map.gwy"), map, {});
    }
    sync();  // no writing back while the loads are timed
    std::vector<Load> loads = {
        {.name = "raw read of the floats", .command = ownCommand("raw", folder.file("map.raw"))},
        {.name = ".gsf", .command = ownCommand("ours", folder.file("map.gsf"))},
        {.name = ".gwy", .command = ownCommand("ours", folder.file("map.gwy"))},
#ifdef ASPERITY_GWYDDION_LOAD
        {.name = kByGwyddion,
         .command = quoted(ASPERITY_GWYDDION_LOAD) + " " + quoted(folder.file("map.gwy"))},
#endif
    };
    measure(loads);
    requireSameSums(loads, static_cast<double>(pixels) * pixels);
    std::printf("%d x %d pixels, fresh processes, warm cache, best of %d\n", pixels, pixels,
                kLoadRounds);
    print(loads);
    const std::optional<double> gwyddion = timeOf(loads, kByGwyddion);
    const std::string load = "load " + std::to_string(pixels) + "^2: ";
    giveRows({{.name = load + ".gsf over a raw read",
               .value = loads[1].time / loads[0].time,
               .unit = "x",
               .goal = 1.3,
               .kind = GoalKind::AtMost},
              {.name = load + "Gwyddion over our .gwy",
               .value = gwyddion ? std::optional(*gwyddion / loads[2].time) : std::nullopt,
               .unit = "x",
               .goal = 3.0}},
             options);
}

/// OpenEXR's own reader: the format is written for other programs, and we do not read it.
void measureExr(const BenchFolder& folder) {
    writeHeightMap(folder.file("map.exr"), hills<HeightMap>(kExrPixels), {});
    std::vector<Load> loads = {
        {.name = ".exr (zip) by OpenEXR", .command = ownCommand("exr", folder.file("map.exr"))}};
    measure(loads);
    std::printf("%d x %d pixels\n", kExrPixels, kExrPixels);
    print(loads);
}

struct Options {
    std::string way;
    std::string path;  ///< of the way
    BenchOptions bench;
};

void run(const Options& options) {
    if (options.path.empty()) {
        const BenchFolder folder;
        measureScan(folder, options.bench);
        measureExr(folder);
    } else if (options.way == "formats") {
        measureFormats(options.path);
    } else if (options.way == "raw") {
        loadRaw(options.path);
    } else if (options.way == "all") {
        loadAll(options.path);
    } else if (options.way == "ours") {
        loadOurs(options.path);
    } else {
        loadExr(options.path);
    }
}

int runBench(int argc, char** argv) {
    Options options;
    CLI::App app("Loading of scans, each in a fresh process, beside a raw read and Gwyddion");
    CLI::Option* const way =
        app.add_option("WAY", options.way, "formats: every file of a folder; else one load")
            ->check(CLI::IsMember({"formats", "raw", "ours", "all", "exr"}));
    CLI::Option* const path = app.add_option("PATH", options.path, "folder, or file of one load");
    way->needs(path);
    addBenchOptions(app, options.bench);
    CLI11_PARSE(app, argc, argv);
    run(options);
    return 0;
}

}  // namespace

}  // namespace asperity

int main(int argc, char** argv) { return asperity::benchMain(argc, argv, asperity::runBench); }
