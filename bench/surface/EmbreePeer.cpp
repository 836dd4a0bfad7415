// Embree 3 (Apache 2.0): its point query on the mesh.
#include "bench/surface/MeshMethod.h"
#include "bench/surface/Peers.h"
#include "bench/surface/TriangleClosestPoint.h"
#include "core/Error.h"

#include <embree3/rtcore.h>
#include <limits>

namespace asperity {

namespace {

using Point = Eigen::Vector3f;

constexpr double kUnit = 1e-9;  // [m]: Embree computes in float

/// Data by which the callback shrinks the search.
struct Search {
    const std::vector<Point>* points = nullptr;  ///< [nm]
    const std::vector<std::array<std::uint32_t, 3>>* triangles = nullptr;
    Point query = Point::Zero();
    Point nearest = Point::Zero();
    float distance = std::numeric_limits<float>::infinity();
};

bool visit(RTCPointQueryFunctionArguments* arguments) {
    Search& search = *static_cast<Search*>(arguments->userPtr);
    const auto& corners = (*search.triangles)[arguments->primID];
    const std::vector<Point>& points = *search.points;
    const Point nearest =
        nearestOnTriangle(search.query, points[corners[0]], points[corners[1]], points[corners[2]]);
    const float distance = (nearest - search.query).norm();
    if (distance >= search.distance) {
        return false;
    }
    search.nearest = nearest;
    search.distance = distance;
    arguments->query->radius = distance;
    return true;
}

class Embree : public MeshLocator {
public:
    explicit Embree(const SurfaceMesh& mesh)
        : device_(rtcNewDevice(nullptr), rtcReleaseDevice)
        , scene_(rtcNewScene(device_.get()), rtcReleaseScene)
        , triangles_(mesh.triangles) {
        for (const Vector3& point : mesh.points) {
            points_.emplace_back((point / kUnit).cast<float>());
        }
        // Embree reads 16 bytes at the last point too.
        points_.reserve(points_.size() + 2);
        RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                   points_.data(), 0, sizeof(Point), points_.size());
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                   triangles_.data(), 0, sizeof(triangles_[0]), triangles_.size());
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_.get(), geometry);
        rtcReleaseGeometry(geometry);
        rtcSetSceneBuildQuality(scene_.get(), RTC_BUILD_QUALITY_HIGH);
        rtcCommitScene(scene_.get());
        if (rtcGetDeviceError(device_.get()) != RTC_ERROR_NONE) {
            throw Error("Embree could not take the mesh");
        }
    }

    [[nodiscard]] std::string name() const override { return "Embree"; }

    [[nodiscard]] Vector3 nearest(const Vector3& query, const Vector3& last) override {
        Search search{.points = &points_,
                      .triangles = &triangles_,
                      .query = (query / kUnit).cast<float>(),
                      .nearest = (last / kUnit).cast<float>()};
        RTCPointQuery within{};
        within.x = search.query.x();
        within.y = search.query.y();
        within.z = search.query.z();
        // The last answer lies on the mesh too: nothing farther needs to be looked at.
        search.distance = (search.nearest - search.query).norm();
        within.radius = search.distance;
        RTCPointQueryContext context;
        rtcInitPointQueryContext(&context);
        rtcPointQuery(scene_.get(), &within, &context, visit, &search);
        return search.nearest.cast<double>() * kUnit;
    }

private:
    std::unique_ptr<RTCDeviceTy, void (*)(RTCDevice)> device_;
    std::unique_ptr<RTCSceneTy, void (*)(RTCScene)> scene_;
    std::vector<Point> points_;  ///< [nm]
    std::vector<std::array<std::uint32_t, 3>> triangles_;
};

}  // namespace

std::unique_ptr<SearchMethod> embreeMethod(const BSplineSurface& surface) {
    return meshMethod(surface, std::make_unique<Embree>(meshOf(surface)));
}

}  // namespace asperity
