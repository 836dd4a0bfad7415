#include "core/identify/ElasticFit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace asperity {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr std::size_t kRoughSamples = 400;  ///< of the fits that find the start of the last one

/// The samples of a fit, their bases from `center` on, which keeps offset and tilt apart.
struct ElasticProblem {
    VectorXd base;
    VectorXd force;
    double center = 0.0;
    double stiffness = 0.0;
    const TipLaw* tip = nullptr;

    [[nodiscard]] double indentation(const VectorXd& p, Index i) const {
        const double deflection = (force[i] - p[2] - (p[3] * base[i])) / stiffness;
        return base[i] - deflection - p[1];
    }

    void residuals(const VectorXd& p, VectorXd& result) const {
        for (Index i = 0; i < base.size(); ++i) {
            const double depth = indentation(p, i);
            const double law = depth > 0.0 ? p[0] * tip->at(depth).force : 0.0;
            result[i] = law + p[2] + (p[3] * base[i]) - force[i];
        }
    }

    void jacobian(const VectorXd& p, MatrixXd& result) const {
        for (Index i = 0; i < base.size(); ++i) {
            const double depth = indentation(p, i);
            const IndentationPoint point = depth > 0.0 ? tip->at(depth) : IndentationPoint{};
            const double rate = p[0] * point.stiffness;
            const double line = 1.0 + (rate / stiffness);
            result(i, 0) = point.force;
            result(i, 1) = -rate;
            result(i, 2) = line;
            result(i, 3) = line * base[i];
        }
    }
};

ElasticProblem problemOf(const BranchSamples& branch, double stiffness, const TipLaw& tip,
                         double center, std::size_t step) {
    ElasticProblem problem;
    problem.center = center;
    problem.stiffness = stiffness;
    problem.tip = &tip;
    const auto count = static_cast<Index>((branch.size() + step - 1) / step);
    problem.base.resize(count);
    problem.force.resize(count);
    for (Index i = 0; i < count; ++i) {
        const std::size_t sample = static_cast<std::size_t>(i) * step;
        problem.base[i] = branch.base[sample] - center;
        problem.force[i] = branch.force[sample];
    }
    return problem;
}

/// Parameters with this contact: baseline by what comes before it, the modulus by what is beyond.
VectorXd startOf(const ElasticProblem& problem, double contact) {
    double before = 0.0;
    double count = 0.0;
    for (Index i = 0; i < problem.base.size(); ++i) {
        if (problem.base[i] < contact) {
            before += problem.force[i];
            count += 1.0;
        }
    }
    VectorXd start(4);
    start << 1.0, contact, count > 0.0 ? before / count : problem.force.minCoeff(), 0.0;
    double product = 0.0;
    double square = 0.0;
    for (Index i = 0; i < problem.base.size(); ++i) {
        const double depth = problem.indentation(start, i);
        if (depth > 0.0) {
            const double law = problem.tip->at(depth).force;
            product += law * (problem.force[i] - start[2]);
            square += law * law;
        }
    }
    start[0] = square > 0.0 ? product / square : 0.0;
    return start;
}

FitResult solve(const ElasticProblem& problem, const VectorXd& start) {
    const double range = problem.force.maxCoeff() - problem.force.minCoeff();
    const double length = problem.base.maxCoeff() - problem.base.minCoeff();
    VectorXd scale(4);
    scale << std::abs(start[0]), 1e-3 * length, 1e-2 * range, 1e-2 * range / length;
    return leastSquares([&](const VectorXd& p, VectorXd& r) { problem.residuals(p, r); }, start,
                        scale, static_cast<std::size_t>(problem.base.size()),
                        [&](const VectorXd& p, MatrixXd& j) { problem.jacobian(p, j); });
}

/// Returns whether a fit has a rising force and its contact among the data.
bool isContact(const ElasticProblem& problem, const FitResult& fit) {
    return std::isfinite(fit.rms) && fit.parameters[0] > 0.0 &&
           fit.parameters[1] > problem.base.minCoeff() &&
           fit.parameters[1] < problem.base.maxCoeff();
}

ElasticFit withoutCenter(const FitResult& fit, double center) {
    const VectorXd& p = fit.parameters;
    ElasticFit result{.reducedModulus = p[0],
                      .contact = p[1] + center,
                      .offset = p[2] - (p[3] * center),
                      .slope = p[3],
                      .rms = fit.rms,
                      .converged = fit.converged};
    Eigen::Matrix4d move = Eigen::Matrix4d::Identity();
    move(2, 3) = -center;
    result.covariance = move * fit.covariance * move.transpose();
    return result;
}

}  // namespace

ElasticFit fitElastic(const BranchSamples& branch, double stiffness, const TipLaw& tip,
                      double start) {
    const auto [far, deep] = std::minmax_element(branch.base.begin(), branch.base.end());
    const double center = std::clamp(start, *far, *deep);
    const std::size_t step = std::max<std::size_t>(1, branch.size() / kRoughSamples);
    const ElasticProblem rough = problemOf(branch, stiffness, tip, center, step);
    std::optional<FitResult> best;
    for (const double share : {0.0, 0.3, -0.5}) {  // towards the deepest base, and back
        const VectorXd first = startOf(rough, share * (*deep - center));
        if (!(first[0] > 0.0)) {
            continue;
        }
        FitResult found = solve(rough, first);
        if (isContact(rough, found) && (!best || found.rms < best->rms)) {
            best = std::move(found);
        }
    }
    if (!best) {
        throw CurveRefusal("no contact: no elastic contact fits within the data");
    }
    const ElasticProblem whole = problemOf(branch, stiffness, tip, center, 1);
    const FitResult fit = step > 1 ? solve(whole, best->parameters) : *best;
    if (!isContact(whole, fit)) {
        throw CurveRefusal("no contact: the fit left the data");
    }
    return withoutCenter(fit, center);
}

ElasticFit fitElasticAt(const BranchSamples& branch, double stiffness, const TipLaw& tip,
                        double contact) {
    const ElasticProblem problem = problemOf(branch, stiffness, tip, contact, 1);
    VectorXd whole = startOf(problem, 0.0);
    if (!(whole[0] > 0.0)) {
        throw CurveRefusal("no contact: the force does not rise beyond the given contact point");
    }
    const auto spread = [&](const VectorXd& p) {
        whole << p[0], 0.0, p[1], p[2];
        return whole;
    };
    MatrixXd derivatives(problem.base.size(), 4);
    VectorXd start(3);
    start << whole[0], whole[2], whole[3];
    VectorXd scale(3);
    const double range = branch.forceRange();
    scale << whole[0], 1e-2 * range,
        1e-2 * range / (problem.base.maxCoeff() - problem.base.minCoeff());
    const FitResult fit =
        leastSquares([&](const VectorXd& p, VectorXd& r) { problem.residuals(spread(p), r); },
                     start, scale, branch.size(),
                     [&](const VectorXd& p, MatrixXd& j) {
                         problem.jacobian(spread(p), derivatives);
                         j << derivatives.col(0), derivatives.rightCols(2);
                     });
    FitResult all = fit;
    all.parameters = spread(fit.parameters);
    all.covariance = MatrixXd::Zero(4, 4);
    const std::array<Index, 3> places{0, 2, 3};
    for (Index i = 0; i < 3; ++i) {
        for (Index j = 0; j < 3; ++j) {
            all.covariance(places[static_cast<std::size_t>(i)],
                           places[static_cast<std::size_t>(j)]) = fit.covariance(i, j);
        }
    }
    ElasticFit result = withoutCenter(all, contact);
    result.contactGiven = true;
    return result;
}

ElasticFit refitElastic(const BranchSamples& branch, double stiffness, const TipLaw& tip,
                        const ElasticFit& near) {
    if (near.contactGiven) {
        return fitElasticAt(branch, stiffness, tip, near.contact);
    }
    const ElasticProblem problem = problemOf(branch, stiffness, tip, near.contact, 1);
    VectorXd start(4);
    start << near.reducedModulus, 0.0, near.baselineAt(near.contact), near.slope;
    return withoutCenter(solve(problem, start), near.contact);
}

BranchSamples windowed(const BranchSamples& branch, const std::vector<double>& force,
                       const ForceWindow& window, double contact) {
    BranchSamples result;
    for (std::size_t i = 0; i < branch.size(); ++i) {
        const bool inside = force[i] >= window.low && force[i] <= window.high;
        if (branch.base[i] < contact || inside) {
            result.base.push_back(branch.base[i]);
            result.force.push_back(branch.force[i]);
            if (!branch.time.empty()) {
                result.time.push_back(branch.time[i]);
            }
        }
    }
    return result;
}

std::vector<double> simulatedForce(const BranchSamples& branch, double stiffness, const TipLaw& tip,
                                   const ElasticFit& fit) {
    constexpr int kMaxSteps = 50;
    const double soft = fit.reducedModulus / stiffness;
    std::vector<double> result(branch.size());
    double depth = 0.0;
    for (std::size_t i = 0; i < branch.size(); ++i) {
        const double approach = branch.base[i] - fit.contact;
        double law = 0.0;
        if (approach > 0.0) {
            // The balance is convex in the indentation: from above Newton falls onto the root.
            depth = approach;
            for (int n = 0; n < kMaxSteps; ++n) {
                const IndentationPoint point = tip.at(depth);
                const double miss = depth + (soft * point.force) - approach;
                const double next = depth - (miss / (1.0 + (soft * point.stiffness)));
                const bool done = !(next < depth) || depth - next < 1e-12 * approach;
                depth = std::max(next, std::numeric_limits<double>::min());
                if (done) {
                    break;
                }
            }
            law = fit.reducedModulus * tip.at(depth).force;
        }
        result[i] = law + fit.baselineAt(branch.base[i]);
    }
    return result;
}

std::vector<double> fittedForce(const BranchSamples& branch, double stiffness, const TipLaw& tip,
                                const ElasticFit& fit) {
    std::vector<double> result(branch.size());
    for (std::size_t i = 0; i < branch.size(); ++i) {
        const double depth = fit.indentation(branch.base[i], branch.force[i], stiffness);
        const double law = depth > 0.0 ? fit.reducedModulus * tip.at(depth).force : 0.0;
        result[i] = law + fit.baselineAt(branch.base[i]);
    }
    return result;
}

}  // namespace asperity
