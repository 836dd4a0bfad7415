// SISL (AGPL 3: linked into this benchmark and nothing else): s1775 on the same spline surface.
#include "bench/surface/Peers.h"
#include "bench/surface/SplinePoles.h"

#include <array>
#include <sisl.h>

namespace asperity {

namespace {

constexpr double kUnit = SplinePoles::kUnit;

SISLSurf* splineOf(const BSplineSurface& surface) {
    const SplinePoles net(surface);
    std::vector<double> knotsX = net.knotsX();
    std::vector<double> knotsY = net.knotsY();
    std::vector<double> poles;
    for (int row = 0; row < net.alongY(); ++row) {
        for (int column = 0; column < net.alongX(); ++column) {
            const Vector3 pole = net.pole(row, column);
            poles.insert(poles.end(), pole.begin(), pole.end());
        }
    }
    constexpr int kOrder = 4;
    constexpr int kPolynomial = 1;
    constexpr int kCopied = 1;
    return newSurf(net.alongX(), net.alongY(), kOrder, kOrder, knotsX.data(), knotsY.data(),
                   poles.data(), kPolynomial, 3, kCopied);
}

class Sisl : public SearchMethod {
public:
    explicit Sisl(const BSplineSurface& surface)
        : surface_(splineOf(surface), freeSurf)
        , low_{0.5 * surface.grid().pitchX / kUnit, 0.5 * surface.grid().pitchY / kUnit}
        , high_{surface.sizeX() / kUnit - low_[0], surface.sizeY() / kUnit - low_[1]} {}

    [[nodiscard]] std::string name() const override { return "SISL s1775, warm"; }

    void start(const Vector2& closest) override { last_ = closest / kUnit; }

    [[nodiscard]] SearchAnswer next(const Vector3& query) override {
        constexpr double kResolution = 1e-9;  // [nm]
        Vector3 point = query / kUnit;
        Vector2 found = last_;
        int status = 0;
        s1775(surface_.get(), point.data(), 3, kResolution, low_.data(), high_.data(), last_.data(),
              found.data(), &status);
        if (status >= 0) {
            last_ = found;
        }
        return {.position = last_ * kUnit};
    }

private:
    std::unique_ptr<SISLSurf, void (*)(SISLSurf*)> surface_;
    std::array<double, 2> low_;       ///< [nm]
    std::array<double, 2> high_;      ///< [nm]
    Vector2 last_ = Vector2::Zero();  ///< [nm]
};

}  // namespace

std::unique_ptr<SearchMethod> sislMethod(const BSplineSurface& surface) {
    return std::make_unique<Sisl>(surface);
}

}  // namespace asperity
