#pragma once

#include "core/surface/Curvature.h"
#include "core/surface/nurbs/BezierNet.h"

#include <array>
#include <span>
#include <vector>

namespace asperity {

/// One rational Bezier patch of a surface, and which part of the surface's parameters it covers.
struct NurbsPatch {
    BezierNet net;
    double lowU = 0.0;
    double highU = 1.0;
    double lowV = 0.0;
    double highV = 1.0;
};

/// A box that holds some of the patches: those of two smaller boxes, or a single one.
struct PatchBox {
    Vector3 low = Vector3::Zero();   ///< world [m]
    Vector3 high = Vector3::Zero();  ///< world [m]
    int patch = -1;                  ///< < 0: the boxes `first` and `second`
    int first = -1;
    int second = -1;

    /// Squared distance from a point to the box [m^2]; 0 inside.
    [[nodiscard]] double squaredDistance(const Vector3& from) const {
        return (from - from.cwiseMax(low).cwiseMin(high)).squaredNorm();
    }
};

/// A rational tensor-product B-spline surface in space: immutable, safe to read from any thread.
/// Su x Sv points out of the sample. Both parameters go from 0 to 1, whatever the knots.
/// Source: Piegl, Tiller: The NURBS Book (1997), chapters 4 and 5.
class NurbsSurface {
public:
    struct Net {
        int degreeU = 1;
        int degreeV = 1;
        std::vector<double> knotsU;   ///< never falling; as many as control points + degree + 1
        std::vector<double> knotsV;   ///<
        std::vector<Vector3> points;  ///< control points, those along u next to each other [m]
        std::vector<double> weights;  ///< one a control point, > 0; empty: all 1
    };

    /// @throw Error when a degree is not 1 to kMaxDegree, the knots fall, a knot inside is
    ///        repeated more often than the degree, a size does not match, a number is not finite or
    ///        beyond kMaxCoordinate, or the weights are not within kWeightRatio of each other
    explicit NurbsSurface(const Net& net);

    /// Beyond 0 to 1 the position is taken to be the nearest edge's.
    [[nodiscard]] ParametricSample at(double u, double v) const noexcept;
    /// Unit normal, out of the sample; also where one edge of a patch is a single point (a pole).
    [[nodiscard]] Vector3 normal(double u, double v) const noexcept;
    /// Principal curvatures; at a pole and within a thousandth of its patch, those of the pole.
    [[nodiscard]] PrincipalCurvatures curvatures(double u, double v) const noexcept;

    /// Returns the patch that holds the position.
    [[nodiscard]] int patchAt(double u, double v) const noexcept;
    [[nodiscard]] std::span<const NurbsPatch> patches() const noexcept { return patches_; }
    /// The tree of boxes; the last one holds all.
    [[nodiscard]] std::span<const PatchBox> boxes() const noexcept { return boxes_; }
    [[nodiscard]] const PatchBox& bounds() const noexcept { return boxes_.back(); }

    /// True where the edge at 0 is the one at 1: along u, along v.
    [[nodiscard]] const std::array<bool, 2>& closed() const noexcept { return closed_; }
    /// True where all of an edge is one point: u = 0, u = 1, v = 0, v = 1.
    [[nodiscard]] const std::array<bool, 4>& collapsed() const noexcept { return collapsed_; }
    /// The sharpest bend of a hollow found on a grid over each patch, >= 0 [1/m]; where patches
    /// meet at an angle, kCrease.
    [[nodiscard]] double concavity() const noexcept { return concavity_; }
    /// Largest magnitude of a control point's coordinate [m]: the scale of rounding errors.
    [[nodiscard]] double scale() const noexcept { return scale_; }

    static constexpr double kMaxCoordinate = 1e9;  // [m]
    static constexpr double kWeightRatio = 1e6;
    static constexpr double kCrease = 1e30;  // [1/m]

private:
    [[nodiscard]] Vector3 edgePoint(int edge, double along) const noexcept;
    [[nodiscard]] int poleNear(double u, double v) const noexcept;
    [[nodiscard]] Vector3 directionAroundPole(int edge, double u, double v) const noexcept;
    [[nodiscard]] PrincipalCurvatures curvaturesOfPole(int edge, double along) const noexcept;
    void findClosedEdges();
    void findConcavity();
    [[nodiscard]] bool hasCrease() const noexcept;

    std::vector<double> breaksU_;  ///< from 0 to 1, where patches meet
    std::vector<double> breaksV_;
    std::vector<NurbsPatch> patches_;  ///< those along u next to each other
    std::vector<PatchBox> boxes_;
    std::array<bool, 2> closed_{};
    std::array<bool, 4> collapsed_{};
    double scale_ = 0.0;
    double concavity_ = 0.0;
};

/// Point and derivatives of one patch, by the surface's parameters; beyond its edges the patch is
/// continued.
[[nodiscard]] ParametricSample sampleOf(const NurbsPatch& patch, double u, double v) noexcept;

/// Returns the principal curvatures from the first and second fundamental form, positive for a
/// bump; both 0 where the surface has no tangent plane.
/// @param normal unit, out of the sample
[[nodiscard]] PrincipalCurvatures principalCurvatures(const ParametricSample& sample,
                                                      const Vector3& normal) noexcept;

/// A surface cut at its knots into rational Bezier patches.
struct NurbsDecomposition {
    std::vector<double> breaksU;  ///< from 0 to 1
    std::vector<double> breaksV;
    std::vector<NurbsPatch> patches;  ///< those along u next to each other
};

/// @throw Error as NurbsSurface()
[[nodiscard]] NurbsDecomposition decomposed(const NurbsSurface::Net& net);

/// A tree over the boxes of the patches, children before parents.
[[nodiscard]] std::vector<PatchBox> boxTree(const std::vector<NurbsPatch>& patches);

}  // namespace asperity
