#include "bench/surface/OurQuery.h"

#include "bench/surface/FootNewton.h"
#include "core/surface/foot/ClosestPoint.h"

namespace asperity {

namespace {

/// The product along a path.
class OurMethod : public FootMethod {
public:
    OurMethod(const BSplineSurface& surface, FootEffort effort)
        : surface_(surface), effort_(effort) {}

    [[nodiscard]] std::string name() const override {
        return std::string("Asperity, ") + keyOf(effort_);
    }

    void start(const Vector2& foot) override {
        guess_ = {foot.x(), foot.y(), true};
        tracker_ = {};
    }

    [[nodiscard]] FootAnswer next(const Vector3& query) override {
        const SurfaceFoot foot = closestPoint(surface_, query, guess_, tracker_, effort_);
        guess_ = foot.guess();
        return {.place = foot.point.head<2>(), .certified = foot.certified()};
    }

private:
    const BSplineSurface& surface_;
    FootEffort effort_;
    FootGuess guess_;
    FootTracker tracker_;
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

std::unique_ptr<FootMethod> ourMethod(const BSplineSurface& surface, FootEffort effort) {
    return std::make_unique<OurMethod>(surface, effort);
}

std::unique_ptr<FootMethod> warmNewtonMethod(const BSplineSurface& surface) {
    return std::make_unique<WarmNewton>(surface);
}

}  // namespace asperity
