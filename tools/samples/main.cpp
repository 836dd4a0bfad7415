#include "core/Error.h"
#include "core/io/heightmap/HeightMapWriter.h"
#include "tools/samples/SampleScans.h"

#include <cstdlib>
#include <filesystem>
#include <iostream>

namespace {

void writeSamples(const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    for (const asperity::SampleScan& sample : asperity::makeSampleScans()) {
        asperity::writeHeightMap(folder / sample.fileName, sample.map,
                                 {.title = sample.title, .unit = sample.unit});
    }
}

}  // namespace

/// Writes the scans of data/samples: asperity_samples OUTDIR.
int main(int argc, char** argv) {
    constexpr int kWrongUsage = 2;
    if (argc != 2) {
        std::cerr << "usage: asperity_samples OUTDIR\n";
        return kWrongUsage;
    }
    try {
        writeSamples(argv[1]);
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        return EXIT_FAILURE;
    }
    return EXIT_SUCCESS;
}
