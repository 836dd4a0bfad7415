#pragma once

#include "core/contact/ContactState.h"
#include "core/contact/laws/ContactLaw.h"
#include "core/contact/laws/ContactModel.h"
#include "core/contact/maugis/MaugisDugdale.h"
#include "tests/support/ReferenceTable.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <rapidcheck.h>
#include <string>
#include <tuple>

namespace asperity {

/// Lets RapidCheck print a counter-example.
inline void showValue(const ContactPair& pair, std::ostream& stream) {
    stream << "R " << pair.tipRadius << " m, E* " << pair.reducedModulus << " Pa, w "
           << pair.workOfAdhesion << " J/m^2";
}

}  // namespace asperity

namespace asperity::test {

/// |actual - expected| at most `tolerance` times |expected|, or times `unit` where that is larger.
inline void expectClose(double actual, double expected, double tolerance, double unit = 0.0) {
    EXPECT_NEAR(actual, expected, tolerance * std::max(std::abs(expected), unit));
}

/// Indentation and force of a state, relative to the units where they vanish.
inline void expectPoint(const LawPoint& point, double indentation, double force,
                        const MaugisUnits& units, double tolerance) {
    expectClose(point.indentation, indentation, tolerance, units.indentation);
    expectClose(point.force, force, tolerance, units.force);
}

/// The row of T16 for a material with the recommended cohesive range (tag H357).
inline ContactPair paperPair(const std::string& material) {
    const ReferenceTable table = referenceTable("T16_parameters.csv");
    for (std::size_t row = 0; row < table.rows(); ++row) {
        if (table.text(row, "material") == material && table.text(row, "tag") == "H357") {
            return {table.number(row, "R"), table.number(row, "Es"), table.number(row, "w")};
        }
    }
    ADD_FAILURE() << "no material " << material;
    return {};
}

/// Uniform in the logarithm.
inline rc::Gen<double> logUniform(double low, double high) {
    constexpr int kSteps = 1'000'000;
    return rc::gen::map(rc::gen::inRange(0, kSteps + 1), [low, high](int step) {
        return low * std::pow(high / low, static_cast<double>(step) / kSteps);
    });
}

/// Uniform in 0 .. 1.
inline rc::Gen<double> fraction() {
    constexpr int kSteps = 1'000'000;
    return rc::gen::map(rc::gen::inRange(0, kSteps + 1),
                        [](int step) { return static_cast<double>(step) / kSteps; });
}

/// Any tip and sample from gel to diamond: E 1 kPa .. 1 TPa, w 1e-6 .. 10 J/m^2, R 1 nm .. 10 um.
inline rc::Gen<ContactPair> adhesivePair() {
    return rc::gen::map(
        rc::gen::tuple(logUniform(1e3, 1e12), logUniform(1e-6, 10.0), logUniform(1e-9, 1e-5),
                       fraction()),
        [](const std::tuple<double, double, double, double>& p) {
            const Elastic sample{std::get<0>(p), 0.5 * std::get<3>(p)};
            const Elastic tip{169e9, 0.27};
            return ContactPair{std::get<2>(p), reducedModulus(sample, tip), std::get<1>(p)};
        });
}

/// A lever from rigid to one that bends under its own weight [m/N].
inline rc::Gen<double> anyCompliance() {
    return rc::gen::oneOf(rc::gen::just(0.0), logUniform(1e-6, 1e4));
}

/// Whether a state has only finite values, its coordinate aside.
inline bool isFinite(const ContactState& state) {
    return std::isfinite(state.force) && std::isfinite(state.indentation) &&
           std::isfinite(state.contactRadius) && std::isfinite(state.cohesiveRadius) &&
           std::isfinite(state.stiffness) && std::isfinite(state.energyLost);
}

inline double stiffnessOf(const MaugisPoint& point) {
    return point.forceRate / point.indentationRate;
}

/// Which states are looked at.
struct BranchOnLever {
    double compliance = 0.0;  ///< [m/N]
    ContactBranch branch = ContactBranch::Bonded;
};

/// What is left of the change of force between two approaches on one branch when the interval is
/// halved 40 times, each time towards the larger change: a step of the force would be left whole.
inline double stepWithin(const ContactModel& model, const BranchOnLever& on, double low,
                         double high) {
    const auto force = [&](double approach) {
        return model.equilibrium(approach, on.compliance, {on.branch}).force;
    };
    for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (low + high);
        const double below = std::abs(force(middle) - force(low));
        const double above = std::abs(force(high) - force(middle));
        (above > below ? low : high) = middle;
    }
    return std::abs(force(high) - force(low));
}

/// Runs a property and makes its counter-example a test failure.
template <typename Property>
void checkProperty(const Property& property) {
    EXPECT_TRUE(rc::check(property));
}

}  // namespace asperity::test
