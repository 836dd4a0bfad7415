#include "core/words/ModelWords.h"

#include "core/FormattedText.h"
#include "core/SiFormat.h"
#include "core/contact/maugis/MaugisTable.h"
#include "core/scene/BelievedModel.h"
#include "core/scene/Scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace asperity {

namespace {

/// In the order of LawReason.
constexpr std::array kLawReasons{
    "as requested",
    "set by the scene's terms",
    "auto: no adhesion",
    "auto: a film, no adhesion",
    "auto: two works of adhesion",
    "auto: no adhesion, a tip with a cone",
    "below 0.3: Maugis-Dugdale, exact from DMT to JKR, with its van der Waals tail before contact",
    "above 0.3: paraboloid not valid, exact sphere used"};

std::string factText(ModelTerm term, const TermFact& fact) {
    const auto [amount, other] = fact;
    switch (term) {
    case ModelTerm::Adhesion:
        return formatted("adhesive force up to %.3g nN, load up to %.3g nN in sampled runs",
                         1e9 * amount, 1e9 * other);
    case ModelTerm::VanDerWaalsTail:
        return formatted("attraction reaches across the gap; transition parameter %.2g", amount);
    case ModelTerm::SphereCorrection:
        return formatted("contact radius up to %.2g tip radii", amount);
    case ModelTerm::FilmBase:
        return formatted("contact radius up to %.2g film thicknesses", amount);
    case ModelTerm::SampleCurvature:
        return formatted("sample curvature up to %.2g of the tip's curvature", amount);
    case ModelTerm::BodyAttraction:
        return formatted("the sample beside contacts pulls with up to %.3g nN", 1e9 * amount);
    case ModelTerm::RetractWork:
        return formatted("the work on retract is %.3g times that on approach", amount);
    case ModelTerm::Relaxation:
        return formatted("the modulus is %.3g times as high at once as after %.3g s", amount,
                         other);
    case ModelTerm::Drag:
        return formatted("drag of %.3g nN s/m in contact", 1e9 * amount);
    case ModelTerm::Friction:
        return formatted("friction coefficient %.2g, shear strength %.2g MPa", amount,
                         1e-6 * other);
    case ModelTerm::Torsion:
        return formatted("lateral compliance is %.2g times that along z", amount);
    case ModelTerm::MountTilt:
        return formatted("lever tilt %.3g degrees", amount * 180.0 / std::numbers::pi);
    default:
        return std::isinf(amount)
                   ? "a shape may have several contact points"
                   : formatted("valley curvature up to %.2g of the tip's curvature", amount);
    }
}

std::string surfaceText(ModelTerm term, const SurfaceNeeds& surface) {
    if (!surface.touches) {
        return "no contact in the sampled runs";
    }
    if (term == ModelTerm::OutsideDisplacement) {
        return "the surface is displaced outside the contact, too";
    }
    const bool somewhere = surface.halfSpace > 0.0;
    return somewhere && !surface.halfSpaceHolds ? "not valid at every contact"
                                                : sentenceOf(surface.deepest);
}

std::string reasonText(const TermNeed& need, const RequiredTerms& needs) {
    if (need.fact) {
        return factText(need.term, *need.fact);
    }
    if (needs.pending) {
        return "not measured yet";
    }
    if (!needs.measured) {
        return formatted("not measured: a tick takes %.2g ms here", needs.fullTick * 1e3);
    }
    return isOfSurface(need.term) ? surfaceText(need.term, needs.surface)
                                  : whyImpossible(need.term);
}

/// Two digits without a power of ten, rounded up: the error is within what is said, and what is not
/// zero is not shown as zero.
std::string percent(double share) {
    constexpr double kMinShown = 1e-4;
    const double shown = share > 0.0 ? 100.0 * std::max(roundedUp(share), kMinShown) : 0.0;
    return formatted(shown < 99.5 ? "%.2g %%" : "%.0f %%", shown);
}

void list(std::string& names, ModelTerm term) {
    names += (names.empty() ? "" : ", ") + std::string(nameOf(term));
}

}  // namespace

const char* whyImpossible(ModelTerm term) noexcept {
    switch (term) {
    case ModelTerm::FilmBase:
        return "the sample is no film";
    case ModelTerm::BodyAttraction:
        return "the tip is nowhere blunt on the scan, or nothing adheres";
    case ModelTerm::RetractWork:
        return "the sample has no other work of adhesion on retract";
    case ModelTerm::Relaxation:
        return "the sample does not relax";
    case ModelTerm::Drag:
        return "no liquid drags the tip";
    default:
        return "the materials do not adhere";
    }
}

std::string whyOf(const LawChoice& choice) {
    const char* const reason = kLawReasons.at(static_cast<std::size_t>(choice.reason));
    return choice.reason < LawReason::NarrowContact
               ? reason
               : formatted("auto: contact radius over tip radius is %.2g without load, %s",
                           choice.unloadedRatio, reason);
}

std::string lawNote(const Scene& scene) {
    const LawChoice usual = usualLaw(scene.description);
    const bool isOther = isSphere(scene.model.law) != isSphere(usual.law) ||
                         isFilm(scene.model.law) != isFilm(usual.law);
    std::string note = std::string("contact law: ") + keyOf(scene.model.law) + " (" +
                       (isOther ? std::string("auto: what ") + keyOf(usual.law) +
                                      " cannot include matters more here"
                                : whyOf(usual)) +
                       ")";
    if (const MaugisTable* table = scene.belief.contact.table()) {
        note += formatted("; tabulated, error at most %.2g of the force or pi w R",
                          table->errorBound());
    }
    return note;
}

std::string sentenceOf(const HalfSpaceAnswer& answer) {
    if (!answer.valid()) {
        return std::string("half-space not valid (") + nameOf(answer.verdict) +
               "): closed form shown";
    }
    return "half-space: normal force " + formatSi(answer.force, "N") + ", the contact law " +
           formatSi(answer.state.normalForce, "N");
}

std::string whyOf(const TermNeed& need, const RequiredTerms& needs) {
    std::string why = reasonText(need, needs);
    for (const ModelTerm other : kModelTerms) {
        if (need.effect > needs.tolerance && exclude(need.term, other) && has(needs.full, other) &&
            !has(needs.full, need.term)) {
            why += std::string("; no contact law combines it with the ") + nameOf(other);
        }
    }
    return why;
}

std::string modelErrorText(const RequiredTerms& needs) {
    if (needs.pending) {
        return "error not measured yet";
    }
    if (!needs.measured) {
        return "error not measured";
    }
    const QuantityErrors total = needs.totalErrors();
    const JudgedQuantity worst = total.worstQuantity();
    if (total.worst() == 0.0) {
        return "no error by omitted terms";
    }
    std::string text = "within " + percent(total.worst()) + " (" + nameOf(worst) + ")";
    if (needs.lawErrors[worst] > 0.0) {
        std::string missed;
        std::ranges::for_each(needs.lawMisses, [&](ModelTerm term) { list(missed, term); });
        text += ": " + percent(needs.wholeErrors[worst]) + " by omitted terms, " +
                percent(needs.lawErrors[worst]) + " by terms that no contact law combines (" +
                missed + ")";
    }
    return text;
}

std::string modelNote(const RequiredTerms& needs) {
    std::string out;
    for (const TermNeed& need : needs.terms) {
        const auto& misses = needs.lawMisses;
        if (!need.on && std::ranges::find(misses, need.term) == misses.end()) {
            list(out, need.term);
        }
    }
    const std::string tolerance = formatted(" (tolerance %.2g %%)", 100.0 * needs.tolerance);
    return "model: " + modelErrorText(needs) + tolerance +
           (out.empty() ? ", nothing left out" : "; left out: " + out);
}

std::string nameOf(const ForceModelOptions& options) {
    std::string text = nameOf(options.law);
    text += options.solver == SolverSetting::Table ? ", table" : "";
    text += options.solver == SolverSetting::Exact ? ", exact" : "";
    text += std::string(", ") + keyOf(options.closestPointSearch) + " search";
    text += options.decoupling == DecouplingModel::Planar ? ", planar" : "";
    for (const bool usual : {false, true}) {
        const char* before = usual ? ", without " : ", with ";
        for (const ModelTerm term : kSwitchedTerms) {
            const ModelTermTraits& traits = traitsOf(term);
            if (traits.usual == usual && options.*traits.option != usual) {
                text += std::string(before) + nameOf(term);
                before = ", ";
            }
        }
    }
    return text;
}

}  // namespace asperity
