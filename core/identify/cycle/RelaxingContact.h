#pragma once

#include "core/contact/laws/HertzLaw.h"

#include <cstddef>
#include <vector>

namespace asperity {

/// A sample that relaxes as a standard linear solid, under a tip that a wall's drag slows in a
/// liquid: E(t) = E_inf + E_1 exp(-t / tau), F_d = C v / (gap + h_off).
struct RelaxingParameters {
    double tipRadius = 0.0;        ///< [m]
    bool sphere = true;            ///< exact, not its paraboloid
    double poissonRatio = 0.5;     ///< of the sample
    double longModulus = 0.0;      ///< E_inf [Pa]
    double relaxingModulus = 0.0;  ///< E_1 [Pa]; 0: elastic
    double relaxationTime = 1.0;   ///< tau [s]
    double contactPoint = 0.0;     ///< x0, base position at first touch of the unbent lever [m]
    double drag = 0.0;             ///< C = 6 pi eta R^2 [N s]; 0: none
    double dragOffset = 1.0;       ///< h_off, gap that remains in contact [m]
};

/// Force on a tip with a given motion, by Ting's theory: while the contact shrinks the tip feels
/// the history up to the time at which the contact was last as wide. Exact between samples for an
/// indentation that is a straight line of time there. A step costs the same however long the
/// history is: exponentials continue by recursion. A contact that grows again after it has shrunk
/// is followed to first order, as noise needs it: the theory is for one loading. Source: Ting
/// (1966); docs/theory.md 7.7.
class RelaxingContact {
public:
    /// @param samples that will be taken at most
    RelaxingContact(const RelaxingParameters& parameters, std::size_t samples);

    /// Force at the next time with this indentation then, without going there [N]. At the first
    /// time there is none: the tip has no speed yet.
    [[nodiscard]] double forceAt(double time, double indentation) const noexcept;
    /// Goes there and returns the force [N].
    double advance(double time, double indentation);

private:
    /// A sample of the history, with the two exponential sums of recursion.
    struct Sample {
        double time = 0.0;
        double indentation = 0.0;
        double load = 0.0;        ///< elastic force over E* [m^2]
        double loadRate = 0.0;    ///< derivative of the load by the indentation [m]
        double loadMemory = 0.0;  ///< integral of exp(-(t - s) / tau) d(load)
        double wayMemory = 0.0;   ///< the same of d(indentation)
    };

    [[nodiscard]] Sample after(const Sample& before, double time,
                               double indentation) const noexcept;
    [[nodiscard]] double excess(const Sample& then, const Sample& now) const noexcept;
    [[nodiscard]] std::size_t asWide(const Sample& now) const noexcept;
    [[nodiscard]] double forceOf(const Sample& now, std::size_t count) const noexcept;
    [[nodiscard]] double dragAt(double time, double indentation) const noexcept;
    void load(Sample& sample) const noexcept;

    RelaxingParameters parameters_;
    double plane_;       ///< 1 - nu^2
    SneddonLaw sphere_;  ///< of a unit modulus
    std::vector<Sample> history_;
    std::size_t widest_ = 0;  ///< sample up to which the history of the contact counts
    double deepest_ = 0.0;    ///< largest indentation so far [m]
};

/// Forces of a tip whose indentation was measured, a value a time [N].
[[nodiscard]] std::vector<double> relaxingForces(const RelaxingParameters& parameters,
                                                 const std::vector<double>& times,
                                                 const std::vector<double>& indentations);

/// Forces on a lever from the motion of its base alone [N].
/// @param stiffness of the lever [N/m]
[[nodiscard]] std::vector<double> simulatedForces(const RelaxingParameters& parameters,
                                                  double stiffness,
                                                  const std::vector<double>& times,
                                                  const std::vector<double>& bases);

}  // namespace asperity
