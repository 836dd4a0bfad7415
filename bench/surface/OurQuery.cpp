#include "bench/surface/OurQuery.h"

#include "bench/surface/NewtonSearch.h"
#include "core/surface/closest/ClosestPointSearch.h"

namespace asperity {

namespace {

/// The product along a path.
class OurMethod : public SearchMethod {
public:
    OurMethod(const BSplineSurface& surface, SearchEffort effort)
        : surface_(surface), effort_(effort) {}

    [[nodiscard]] std::string name() const override {
        return std::string("Asperity, ") + keyOf(effort_);
    }

    void start(const Vector2& closest) override {
        guess_ = {closest.x(), closest.y(), true};
        tracker_ = {};
    }

    [[nodiscard]] SearchAnswer next(const Vector3& query) override {
        const ClosestPoint closest = closestPoint(surface_, query, guess_, tracker_, effort_);
        guess_ = closest.guess();
        return {.position = closest.point.head<2>(), .certified = closest.certified()};
    }

private:
    const BSplineSurface& surface_;
    SearchEffort effort_;
    SearchGuess guess_;
    ClosestPointTracker tracker_;
};

class WarmNewton : public SearchMethod {
public:
    explicit WarmNewton(const BSplineSurface& surface)
        : surface_(surface), end_{1e-3 * surface.grid().pitchX} {}

    [[nodiscard]] std::string name() const override { return "warm Newton alone"; }

    void start(const Vector2& closest) override { last_ = closest; }

    [[nodiscard]] SearchAnswer next(const Vector3& query) override {
        last_ = newtonPoint(surface_, query, last_, end_);
        return {.position = last_};
    }

private:
    const BSplineSurface& surface_;
    NewtonEnd end_;  ///< the last step is squared away: the distance errs by 1e-9 nm at most
    Vector2 last_ = Vector2::Zero();
};

}  // namespace

std::unique_ptr<SearchMethod> ourMethod(const BSplineSurface& surface, SearchEffort effort) {
    return std::make_unique<OurMethod>(surface, effort);
}

std::unique_ptr<SearchMethod> warmNewtonMethod(const BSplineSurface& surface) {
    return std::make_unique<WarmNewton>(surface);
}

}  // namespace asperity
