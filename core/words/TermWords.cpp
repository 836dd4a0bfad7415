#include "core/words/TermWords.h"

#include "core/FormattedText.h"
#include "core/words/HalfSpaceWords.h"

#include <numbers>

namespace asperity {

namespace {

std::string factText(const TermNeed& need, const SceneNeeds& needs) {
    const auto [amount, other] = need.fact;
    switch (need.term) {
    case ModelTerm::Adhesion:
        return formatted("it pulls with up to %.3g nN, pressed by up to %.3g nN", 1e9 * amount,
                         1e9 * other);
    case ModelTerm::VanDerWaalsTail:
        return formatted("attraction reaches across the gap; transition parameter %.2g", amount);
    case ModelTerm::SphereCorrection:
        return formatted("the contact is up to %.2g tip radii wide", amount);
    case ModelTerm::FilmBase:
        return formatted("the contact is up to %.2g film thicknesses wide", amount);
    case ModelTerm::SampleCurvature:
        return formatted("the sample is curved by up to %.2g of the tip's own curvature", amount);
    case ModelTerm::Friction:
        return formatted("friction coefficient %.2g, shear strength %.2g MPa", amount,
                         1e-6 * other);
    case ModelTerm::Torsion:
        return formatted("across the lever the tip yields %.2g times as much as along z", amount);
    case ModelTerm::MountTilt:
        return formatted("the lever is tilted by %.3g degrees",
                         amount * 180.0 / std::numbers::pi);
    case ModelTerm::GlobalSearch:
        return formatted("hollows are curved by up to %.2g of the tip's own curvature", amount);
    case ModelTerm::OutsideDisplacement:
        return "a sample yields beyond the rim of the contact, too";
    case ModelTerm::HalfSpaceSolve:
        break;
    }
    return sentenceOf(needs.halfSpace);
}

std::string reasonText(const TermNeed& need, const SceneNeeds& needs) {
    switch (need.reason) {
    case NeedReason::Unknown:
        break;
    case NeedReason::NotTried:
        return formatted("not tried: a tick takes %.2g ms here", needs.fullTick * 1e3);
    case NeedReason::Impossible:
        return need.term == ModelTerm::FilmBase ? "the sample is no film"
                                                : "the materials do not adhere";
    case NeedReason::Fact:
        return factText(need, needs);
    case NeedReason::AnyShape:
        return "a shape may come near at several places";
    case NeedReason::NoContact:
        return "the sampled runs touch nothing";
    case NeedReason::NotEverywhere:
        return "it does not hold at every contact";
    }
    return {};
}

}  // namespace

std::string whyOf(const TermNeed& need, const SceneNeeds& needs) {
    std::string why = reasonText(need, needs);
    if (need.effect > needs.tolerance && !has(needs.full, need.term)) {
        for (const ModelTerm other : kModelTerms) {
            if (exclude(need.term, other) && has(needs.full, other)) {
                why += std::string("; no contact law has it beside the ") + nameOf(other);
            }
        }
    }
    return why;
}

}  // namespace asperity
