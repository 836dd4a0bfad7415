// Open CASCADE (LGPL 2.1 with exception): the same spline surface, warm and over a window.
#include "bench/surface/Peers.h"
#include "bench/surface/SplinePoles.h"

#include <Extrema_GenLocateExtPS.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <algorithm>
#include <gp_Pnt.hxx>

namespace asperity {

namespace {

constexpr double kUnit = SplinePoles::kUnit;

TColStd_Array1OfReal arrayOf(const std::vector<double>& values) {
    TColStd_Array1OfReal array(1, static_cast<int>(values.size()));
    std::copy(values.begin(), values.end(), array.begin());
    return array;
}

Handle(Geom_BSplineSurface) splineOf(const BSplineSurface& surface) {
    const SplinePoles net(surface);
    TColgp_Array2OfPnt poles(1, net.alongX(), 1, net.alongY());
    for (int row = 0; row < net.alongY(); ++row) {
        for (int column = 0; column < net.alongX(); ++column) {
            const Vector3 pole = net.pole(row, column);
            poles.SetValue(column + 1, row + 1, gp_Pnt(pole.x(), pole.y(), pole.z()));
        }
    }
    const TColStd_Array1OfReal knotsX = arrayOf(net.knotsX());
    const TColStd_Array1OfReal knotsY = arrayOf(net.knotsY());
    TColStd_Array1OfInteger onceX(1, knotsX.Length());
    TColStd_Array1OfInteger onceY(1, knotsY.Length());
    onceX.Init(1);
    onceY.Init(1);
    constexpr int kDegree = 3;
    return new Geom_BSplineSurface(poles, knotsX, knotsY, onceX, onceY, kDegree, kDegree);
}

gp_Pnt scaled(const Vector3& point) {
    return {point.x() / kUnit, point.y() / kUnit, point.z() / kUnit};
}

/// GenLocateExtPS from the closest point of the query before.
class OpenCascadeWarm : public SearchMethod {
public:
    explicit OpenCascadeWarm(const BSplineSurface& surface)
        : surface_(splineOf(surface)), search_(surface_) {}

    [[nodiscard]] std::string name() const override { return "OpenCASCADE GenLocateExtPS, warm"; }

    void start(const Vector2& closest) override { last_ = closest / kUnit; }

    [[nodiscard]] SearchAnswer next(const Vector3& query) override {
        search_.Perform(scaled(query), last_.x(), last_.y());
        if (search_.IsDone()) {
            search_.Point().Parameter(last_.x(), last_.y());
        }
        return {.position = last_ * kUnit};
    }

private:
    GeomAdaptor_Surface surface_;
    Extrema_GenLocateExtPS search_;
    Vector2 last_ = Vector2::Zero();  ///< [nm]
};

/// ProjectPointOnSurf over a window around the tip.
class OpenCascadeWindow : public SearchMethod {
public:
    explicit OpenCascadeWindow(const BSplineSurface& surface) : surface_(splineOf(surface)) {}

    [[nodiscard]] std::string name() const override {
        return "OpenCASCADE ProjectPointOnSurf, +-24 nm";
    }
    [[nodiscard]] std::size_t mostQueries() const override { return kMaxQueries; }

    void start(const Vector2& closest) override { last_ = closest / kUnit; }

    [[nodiscard]] SearchAnswer next(const Vector3& query) override {
        const Vector2 center = query.head<2>() / kUnit;
        GeomAPI_ProjectPointOnSurf search(scaled(query), surface_, center.x() - kReach,
                                          center.x() + kReach, center.y() - kReach,
                                          center.y() + kReach);
        if (search.IsDone() && search.NbPoints() > 0) {
            search.LowerDistanceParameters(last_.x(), last_.y());
        }
        return {.position = last_ * kUnit};
    }

private:
    static constexpr double kReach = 24.0;  ///< [nm]
    static constexpr std::size_t kMaxQueries = 2000;

    Handle(Geom_BSplineSurface) surface_;
    Vector2 last_ = Vector2::Zero();  ///< [nm]
};

}  // namespace

std::unique_ptr<SearchMethod> openCascadeMethod(const BSplineSurface& surface) {
    return std::make_unique<OpenCascadeWarm>(surface);
}

std::unique_ptr<SearchMethod> openCascadeWindowMethod(const BSplineSurface& surface) {
    return std::make_unique<OpenCascadeWindow>(surface);
}

}  // namespace asperity
