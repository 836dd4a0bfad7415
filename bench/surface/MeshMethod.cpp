#include "bench/surface/MeshMethod.h"

#include "bench/surface/NewtonSearch.h"

#include <utility>

namespace asperity {

namespace {

class MeshMethod : public SearchMethod {
public:
    MeshMethod(const BSplineSurface& surface, std::unique_ptr<MeshLocator> locator)
        : surface_(surface), locator_(std::move(locator)), end_{1e-3 * surface.grid().pitchX} {}

    [[nodiscard]] std::string name() const override {
        return locator_->name() + " on the mesh, then Newton";
    }

    void start(const Vector2& closest) override {
        last_ = Vector3(closest.x(), closest.y(), surface_.at(closest.x(), closest.y()).height);
    }

    [[nodiscard]] SearchAnswer next(const Vector3& query) override {
        last_ = locator_->nearest(query, last_);
        return {.position = newtonPoint(surface_, query, last_.head<2>(), end_)};
    }

private:
    const BSplineSurface& surface_;
    std::unique_ptr<MeshLocator> locator_;
    NewtonEnd end_;
    Vector3 last_ = Vector3::Zero();
};

}  // namespace

SurfaceMesh meshOf(const BSplineSurface& surface) {
    const BSplineSurface::Grid& grid = surface.grid();
    SurfaceMesh mesh;
    const auto columns = static_cast<std::uint32_t>(grid.columns);
    const auto rows = static_cast<std::uint32_t>(grid.rows);
    for (std::uint32_t row = 0; row < rows; ++row) {
        for (std::uint32_t column = 0; column < columns; ++column) {
            const double x = (column + 0.5) * grid.pitchX;
            const double y = (row + 0.5) * grid.pitchY;
            mesh.points.emplace_back(x, y, surface.at(x, y).height);
        }
    }
    for (std::uint32_t row = 0; row + 1 < rows; ++row) {
        for (std::uint32_t column = 0; column + 1 < columns; ++column) {
            const std::uint32_t corner = row * columns + column;
            mesh.triangles.push_back({corner, corner + 1, corner + columns + 1});
            mesh.triangles.push_back({corner, corner + columns + 1, corner + columns});
        }
    }
    return mesh;
}

std::unique_ptr<SearchMethod> meshMethod(const BSplineSurface& surface,
                                         std::unique_ptr<MeshLocator> locator) {
    return std::make_unique<MeshMethod>(surface, std::move(locator));
}

}  // namespace asperity
