#pragma once

#include "core/identify/CurvePreparation.h"
#include "core/identify/LeastSquares.h"
#include "core/identify/TipLaw.h"

#include <optional>
#include <vector>

namespace asperity {

/// Samples of a branch with these forces above the baseline are fitted, beside those before
/// contact [N].
struct ForceWindow {
    double low = 0.0;
    double high = 0.0;
};

/// The elastic fit of a branch: all samples, unweighted, by E*, contact point and baseline.
///
/// F = E* g(d) + b0 + b1 x_b with the indentation d = x_b - (F - b0 - b1 x_b) / k - x0 of the
/// measured deflection, so that the fit is in the space of the base and a noisy deflection does not
/// bias a steep contact. Source: docs/measured.md.
struct ElasticFit {
    double reducedModulus = 0.0;  ///< E* [Pa]
    double contact = 0.0;         ///< base at contact x0 [m]
    double offset = 0.0;          ///< b0 [N]
    double slope = 0.0;           ///< b1 [N/m]
    /// Of E*, x0, b0, b1 in this order.
    Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();
    double rms = 0.0;  ///< of the residual [N]
    bool converged = false;
    bool contactGiven = false;  ///< it was not fitted

    [[nodiscard]] double baselineAt(double base) const noexcept { return offset + (slope * base); }
    /// Indentation at the measured deflection [m].
    [[nodiscard]] double indentation(double base, double force, double stiffness) const noexcept {
        return base - ((force - baselineAt(base)) / stiffness) - contact;
    }
};

/// @param start base near the contact [m]  @param tip its table covers what the fit needs
/// @throw CurveRefusal when no contact is found in the data
[[nodiscard]] ElasticFit fitElastic(const BranchSamples& branch, double stiffness,
                                    const TipLaw& tip, double start);
/// The same with a given contact point. @param contact base at contact [m]
[[nodiscard]] ElasticFit fitElasticAt(const BranchSamples& branch, double stiffness,
                                      const TipLaw& tip, double contact);

/// The same from a fit near it: of other samples, with another calibration.
[[nodiscard]] ElasticFit refitElastic(const BranchSamples& branch, double stiffness,
                                      const TipLaw& tip, const ElasticFit& near);

/// Returns the samples of a branch whose force, without baseline, is in the window or that come
/// before contact. @param contact base at contact [m]
[[nodiscard]] BranchSamples windowed(const BranchSamples& branch, const std::vector<double>& force,
                                     const ForceWindow& window, double contact);

/// Force at each base of a branch by the fit alone, base motion and lever: what the deflection was
/// is not asked [N].
[[nodiscard]] std::vector<double> simulatedForce(const BranchSamples& branch, double stiffness,
                                                 const TipLaw& tip, const ElasticFit& fit);
/// Force of the fit at each indentation measured, with its baseline [N].
[[nodiscard]] std::vector<double> fittedForce(const BranchSamples& branch, double stiffness,
                                              const TipLaw& tip, const ElasticFit& fit);

}  // namespace asperity
