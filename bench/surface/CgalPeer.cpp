// CGAL (GPL 3 for its AABB tree: linked into this benchmark and nothing else): its tree on the
// mesh.
#include "bench/surface/MeshMethod.h"
#include "bench/surface/Peers.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

namespace asperity {

namespace {

constexpr double kUnit = 1e-9;  // [m]

using Kernel = CGAL::Simple_cartesian<double>;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

Kernel::Point_3 scaled(const Vector3& point) {
    return {point.x() / kUnit, point.y() / kUnit, point.z() / kUnit};
}

Triangles trianglesOf(const SurfaceMesh& mesh) {
    Triangles triangles;
    for (const auto& [a, b, c] : mesh.triangles) {
        triangles.emplace_back(scaled(mesh.points[a]), scaled(mesh.points[b]),
                               scaled(mesh.points[c]));
    }
    return triangles;
}

class Cgal : public MeshLocator {
public:
    explicit Cgal(const SurfaceMesh& mesh)
        : triangles_(trianglesOf(mesh)), tree_(triangles_.begin(), triangles_.end()) {
        tree_.build();
    }

    [[nodiscard]] std::string name() const override { return "CGAL AABB tree"; }

    [[nodiscard]] Vector3 nearest(const Vector3& query, const Vector3& last) override {
        const Kernel::Point_3 found = tree_.closest_point(scaled(query), scaled(last));
        return Vector3(found.x(), found.y(), found.z()) * kUnit;
    }

private:
    Triangles triangles_;
    Tree tree_;
};

}  // namespace

std::unique_ptr<SearchMethod> cgalMethod(const BSplineSurface& surface) {
    return meshMethod(surface, std::make_unique<Cgal>(meshOf(surface)));
}

}  // namespace asperity
