#include "bench/surface/OurQuery.h"

#include "bench/surface/FootNewton.h"

namespace asperity {

namespace {

class OurMethod : public FootMethod {
public:
    explicit OurMethod(const BSplineSurface& surface) : surface_(surface) {}

    [[nodiscard]] std::string name() const override { return "Asperity"; }

    void start(const Vector2& foot) override { guess_ = {foot.x(), foot.y(), true}; }

    [[nodiscard]] FootAnswer next(const Vector3& query) override {
        const SurfaceFoot foot = ourFoot(surface_, query, guess_);
        guess_ = {foot.point.x(), foot.point.y(), true};
        return {.place = foot.point.head<2>(), .certified = foot.certified};
    }

private:
    const BSplineSurface& surface_;
    FootGuess guess_;
};

class WarmNewton : public FootMethod {
public:
    explicit WarmNewton(const BSplineSurface& surface)
        : surface_(surface), end_{1e-3 * surface.grid().pitchX} {}

    [[nodiscard]] std::string name() const override { return "warm Newton alone"; }

    void start(const Vector2& foot) override { last_ = foot; }

    [[nodiscard]] FootAnswer next(const Vector3& query) override {
        last_ = newtonFoot(surface_, query, last_, end_);
        return {.place = last_};
    }

private:
    const BSplineSurface& surface_;
    NewtonEnd end_;  ///< the last step is squared away: the distance errs by 1e-9 nm at most
    Vector2 last_ = Vector2::Zero();
};

}  // namespace

SurfaceFoot ourFoot(const BSplineSurface& surface, const Vector3& query, const FootGuess& guess) {
    return closestPoint(surface, query, guess);
}

std::unique_ptr<FootMethod> ourMethod(const BSplineSurface& surface) {
    return std::make_unique<OurMethod>(surface);
}

std::unique_ptr<FootMethod> warmNewtonMethod(const BSplineSurface& surface) {
    return std::make_unique<WarmNewton>(surface);
}

}  // namespace asperity
