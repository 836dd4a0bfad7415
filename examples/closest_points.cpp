// Closest points of a scan to places above it: closest_points SCAN
#include "core/io/heightmap/ScanFile.h"
#include "core/surface/closest/ClosestPointSearch.h"
#include "core/surface/fit/BSplineFit.h"

#include <cstdio>
#include <exception>

namespace {

void printClosestPoints(const char* file) {
    using namespace asperity;
    const HeightScan scan = ScanFile(file).readHeightScan("");
    const BSplineSurface surface = fitSurface(scan.map);
    std::printf("x_m,y_m,z_m,distance_m,normal_z,proof\n");
    for (int i = 1; i < 10; ++i) {
        const double x = 0.1 * i * surface.sizeX();
        const double y = 0.5 * surface.sizeY();
        const Vector3 place(x, y, surface.at(x, y).height + 10e-9);
        const ClosestPoint closest = closestPoint(surface, place, {});
        std::printf("%.6e,%.6e,%.6e,%.4e,%.4f,%s\n", closest.point.x(), closest.point.y(),
                    closest.point.z(), closest.distance, closest.normal.z(), keyOf(closest.proof));
    }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: closest_points SCAN\n");
        return 2;
    }
    try {
        printClosestPoints(argv[1]);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
