#include "bench/surface/OurQuery.h"

#include "bench/surface/FootNewton.h"
#include "core/surface/foot/ClosestPoint.h"
#include "core/surface/foot/LocalFoot.h"

namespace asperity {

namespace {

/// One way of the product, as it is called.
using OurSearch = SurfaceFoot (*)(const BSplineSurface&, const Vector3&, const FootGuess&);

class OurMethod : public FootMethod {
public:
    OurMethod(const BSplineSurface& surface, const char* name, OurSearch search)
        : surface_(surface), name_(name), search_(search) {}

    [[nodiscard]] std::string name() const override { return name_; }

    void start(const Vector2& foot) override { guess_ = {foot.x(), foot.y(), true}; }

    [[nodiscard]] FootAnswer next(const Vector3& query) override {
        const SurfaceFoot foot = search_(surface_, query, guess_);
        guess_ = foot.guess();
        return {.place = foot.point.head<2>(), .certified = foot.certified()};
    }

private:
    const BSplineSurface& surface_;
    const char* name_;
    OurSearch search_;
    FootGuess guess_;
};

/// The product along a path.
class TrackedMethod : public FootMethod {
public:
    explicit TrackedMethod(const BSplineSurface& surface) : surface_(surface) {}

    [[nodiscard]] std::string name() const override { return "Asperity"; }

    void start(const Vector2& foot) override {
        guess_ = {foot.x(), foot.y(), true};
        tracker_ = {};
    }

    [[nodiscard]] FootAnswer next(const Vector3& query) override {
        const SurfaceFoot foot = closestPoint(surface_, query, guess_, tracker_);
        guess_ = foot.guess();
        return {.place = foot.point.head<2>(), .certified = foot.certified()};
    }

private:
    const BSplineSurface& surface_;
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

std::unique_ptr<FootMethod> ourMethod(const BSplineSurface& surface) {
    return std::make_unique<TrackedMethod>(surface);
}

std::unique_ptr<FootMethod> ourLocalMethod(const BSplineSurface& surface) {
    return std::make_unique<OurMethod>(surface, "Asperity, local search alone", localFoot);
}

std::unique_ptr<FootMethod> warmNewtonMethod(const BSplineSurface& surface) {
    return std::make_unique<WarmNewton>(surface);
}

}  // namespace asperity
