#include "core/Error.h"
#include "core/io/heightmap/HeightMapWriter.h"
#include "tools/samples/ParkScan.h"

#include <cstdlib>
#include <iostream>

/// Writes the sample of the default scene from the scan that it is cut out of:
/// asperity_measured_sample example_ps.tiff OUT.gsf.
int main(int argc, char** argv) {
    constexpr int kWrongUsage = 2;
    if (argc != 3) {
        std::cerr << "usage: asperity_measured_sample PARK.tiff OUT.gsf\n";
        return kWrongUsage;
    }
    try {
        asperity::writeHeightMap(argv[2], asperity::granularFilm(asperity::readParkScan(argv[1])),
                                 {.title = asperity::kGranularFilmTitle});
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        return EXIT_FAILURE;
    }
    return EXIT_SUCCESS;
}
