#include "core/haptics/Guide.h"

#include <algorithm>

namespace asperity {

namespace {

constexpr double kComesOnIn = 0.5;       // [s]
constexpr double kMaxGuideStep = 10e-3;  // that a stall counts as [s]

}  // namespace

GuideStep stepGuide(const TickInput& input, const Vector3& place,
                    const GuideMemory& memory) noexcept {
    const Settings& settings = input.settings;
    GuideStep step;
    const bool zoomed =
        settings.guide.kind != FixtureKind::None && settings.positionGain != memory.positionGain;
    step.changed = settings.guide != memory.fixture || zoomed;
    if (step.changed) {
        return step;
    }
    const double more = std::min(input.timeStep, kMaxGuideStep) / kComesOnIn;
    step.share = std::min(1.0, memory.share + more);
    VirtualFixture fixture = atDeviceScale(settings.guide, settings.positionGain);
    fixture.forceLimit *= step.share;
    step.force = guide(fixture, place / settings.positionGain, memory.velocity).force;
    return step;
}

GuideMemory guideAfter(const TickInput& input, const GuideStep& step,
                       const Vector3& motion) noexcept {
    return {.fixture = input.settings.guide,
            .positionGain = input.settings.positionGain,
            .share = step.share,
            .velocity = motion / input.timeStep};
}

}  // namespace asperity
