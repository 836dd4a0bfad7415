#pragma once

#include "bench/surface/SearchMethod.h"
#include "core/surface/BSplineSurface.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace asperity {

/// The surface as triangles: its points at the pixel centers, two triangles a cell.
struct SurfaceMesh {
    std::vector<Vector3> points;                          ///< world [m]
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counter-clockwise seen from above
};
[[nodiscard]] SurfaceMesh meshOf(const BSplineSurface& surface);

/// A mesh that can be asked for its point nearest to a query.
class MeshLocator {
public:
    MeshLocator() = default;
    MeshLocator(const MeshLocator&) = delete;
    MeshLocator& operator=(const MeshLocator&) = delete;
    virtual ~MeshLocator() = default;

    [[nodiscard]] virtual std::string name() const = 0;
    /// @param last the answer to the query before, world [m]
    [[nodiscard]] virtual Vector3 nearest(const Vector3& query, const Vector3& last) = 0;
};

/// The locator's answer, brought to the spline surface by Newton's method.
[[nodiscard]] std::unique_ptr<SearchMethod> meshMethod(const BSplineSurface& surface,
                                                       std::unique_ptr<MeshLocator> locator);

}  // namespace asperity
