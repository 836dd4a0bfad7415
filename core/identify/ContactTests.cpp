#include "core/identify/ContactTests.h"

#include "core/FormattedText.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr double kShallow = 0.15;  ///< of the largest indentation: below, the contact point rules

/// A sample in contact: indentation and force of the sample on the tip.
struct ContactSample {
    double indentation = 0.0;
    double force = 0.0;
    double base = 0.0;
};

std::vector<ContactSample> samplesInContact(const BranchSamples& branch, double stiffness,
                                            const ElasticFit& fit) {
    std::vector<ContactSample> result;
    for (std::size_t i = 0; i < branch.size(); ++i) {
        const double depth = fit.indentation(branch.base[i], branch.force[i], stiffness);
        if (depth > 0.0) {
            result.push_back(
                {depth, branch.force[i] - fit.baselineAt(branch.base[i]), branch.base[i]});
        }
    }
    return result;
}

/// Slope of a line through points.
template <class X, class Y>
double slopeOf(const std::vector<ContactSample>& samples, const X& x, const Y& y) {
    double meanX = 0.0;
    double meanY = 0.0;
    const auto count = static_cast<double>(samples.size());
    for (const ContactSample& sample : samples) {
        meanX += x(sample) / count;
        meanY += y(sample) / count;
    }
    double xx = 0.0;
    double xy = 0.0;
    for (const ContactSample& sample : samples) {
        xx += (x(sample) - meanX) * (x(sample) - meanX);
        xy += (x(sample) - meanX) * (y(sample) - meanY);
    }
    return xx > 0.0 ? xy / xx : 0.0;
}

double exponentOfForce(const std::vector<ContactSample>& samples, double largest) {
    std::vector<ContactSample> deep;
    std::copy_if(samples.begin(), samples.end(), std::back_inserter(deep), [&](const auto& s) {
        return s.indentation > kShallow * largest && s.force > 0.0;
    });
    return slopeOf(
        deep, [](const auto& s) { return std::log(s.indentation); },
        [](const auto& s) { return std::log(s.force); });
}

/// E* by the samples of an interval of the indentation, the contact as it was fitted.
double modulusWithin(const std::vector<ContactSample>& samples, const TipLaw& tip, double low,
                     double high) {
    double product = 0.0;
    double square = 0.0;
    for (const ContactSample& sample : samples) {
        if (sample.indentation >= low && sample.indentation <= high) {
            const double law = tip.at(sample.indentation).force;
            product += law * sample.force;
            square += law * law;
        }
    }
    return square > 0.0 ? product / square : 0.0;
}

double slopeAtTop(const std::vector<ContactSample>& samples, double stiffness) {
    constexpr double kTop = 0.75;
    double largest = 0.0;
    for (const ContactSample& sample : samples) {
        largest = std::max(largest, sample.force);
    }
    std::vector<ContactSample> top;
    std::copy_if(samples.begin(), samples.end(), std::back_inserter(top),
                 [&](const auto& s) { return s.force > kTop * largest; });
    return slopeOf(
        top, [](const auto& s) { return s.base; },
        [stiffness](const auto& s) { return s.force / stiffness; });
}

}  // namespace

ContactTests contactTests(const BranchSamples& branch, double stiffness, double noise,
                          const TipLaw& tip, const ElasticFit& fit, double deviation) {
    const std::vector<ContactSample> samples = samplesInContact(branch, stiffness, fit);
    ContactTests result;
    result.samples = samples.size();
    result.rangeOverNoise = noise > 0.0 ? branch.forceRange() / noise : 1e300;
    for (const ContactSample& sample : samples) {
        result.largestIndentation = std::max(result.largestIndentation, sample.indentation);
    }
    const double largest = result.largestIndentation;
    if (samples.size() < 2) {
        return result;
    }
    result.exponent = exponentOfForce(samples, largest);
    const double lower = modulusWithin(samples, tip, 0.0, 0.5 * largest);
    result.windowRatio =
        lower > 0.0 ? modulusWithin(samples, tip, 0.5 * largest, largest) / lower : 0.0;
    if (hasRadius(tip.tip().kind)) {
        result.radiusRatio = tip.exact(largest).contactRadius / tip.tip().radius;
    }
    result.slope = slopeAtTop(samples, stiffness);
    const IndentationPoint end = tip.exact(largest);
    const double exponent = end.force > 0.0 ? end.stiffness * largest / end.force : 1.5;
    result.contactShare = exponent * (deviation - fit.contact) / largest;
    return result;
}

std::vector<FitConcern> concerns(const ContactTests& tests, const TipForm& tip, bool isKnown) {
    constexpr double kExponentMargin = 0.2;
    constexpr double kWindowMargin = 0.2;
    constexpr double kSteepSlope = 0.9;
    constexpr double kWideContact = 0.5;
    constexpr double kContactMargin = 0.05;
    std::vector<FitConcern> result;
    const auto expected = exponentOf(tip);
    if (expected && std::abs(tests.exponent - *expected) > kExponentMargin) {
        result.push_back({formatted("the force grows with the indentation to the power of %.2f, "
                                    "where the tip would have %.1f",
                                    tests.exponent, *expected)});
    }
    if (std::abs(tests.windowRatio - 1.0) > kWindowMargin) {
        result.push_back({formatted("the modulus depends on the depth: the upper half of the "
                                    "indentation gives %.2f times that of the lower half",
                                    tests.windowRatio)});
    }
    if (tests.slope > kSteepSlope) {
        result.push_back({formatted("the lever bends by %.2f of the base's way at the end: the "
                                    "sample is far stiffer than the lever, and the modulus is only "
                                    "a lower bound",
                                    tests.slope)});
    }
    if (isKnown && tip.kind == TipKind::Paraboloid && tests.radiusRatio > kWideContact) {
        result.push_back({formatted("the contact radius reaches %.2f of the tip radius: a "
                                    "paraboloid is no sphere any more",
                                    tests.radiusRatio)});
    }
    if (isKnown && tip.kind == TipKind::Sphere && tests.largestIndentation > tip.radius) {
        result.push_back({"the indentation exceeds the radius of the sphere"});
    }
    if (!tip.area.empty() && tests.largestIndentation > tip.area.back().height) {
        result.push_back({formatted("the indentation of %.3g m exceeds the height of the area "
                                    "function, %.3g m",
                                    tests.largestIndentation, tip.area.back().height)});
    }
    if (std::abs(tests.contactShare) > kContactMargin) {
        result.push_back({formatted("the contact by deviation would change the modulus by %.0f %%",
                                    100.0 * std::abs(tests.contactShare)),
                          false});
    }
    return result;
}

}  // namespace asperity
