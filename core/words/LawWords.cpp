#include "core/words/LawWords.h"

#include "core/FormattedText.h"
#include "core/contact/maugis/MaugisTable.h"
#include "core/scene/BelievedModel.h"

namespace asperity {

namespace {

std::string whyByWidth(double ratio, const char* rest) {
    return formatted("auto: contact radius over tip radius is %.2g without load, %s", ratio, rest);
}

}  // namespace

std::string whyOf(const LawChoice& choice) {
    switch (choice.reason) {
    case LawReason::AskedFor:
        break;
    case LawReason::TermsOfScene:
        return "as the scene says of its terms";
    case LawReason::NoAdhesion:
        return "auto: no adhesion";
    case LawReason::FilmWithoutAdhesion:
        return "auto: a film, no adhesion";
    case LawReason::NarrowContact:
        return whyByWidth(choice.unloadedRatio,
                          "below 0.3: Maugis-Dugdale, exact from DMT to JKR, with its van der "
                          "Waals tail before contact");
    case LawReason::WideContact:
        return whyByWidth(choice.unloadedRatio,
                          "above 0.3: the paraboloid does not hold, the exact sphere does");
    }
    return "as asked for";
}

std::string lawNote(const Scene& scene) {
    std::string note = std::string("contact law: ") + keyOf(scene.model.law) + " (" +
                       whyOf(usualLaw(scene.description)) + ")";
    if (const MaugisTable* table = scene.belief.contact.table()) {
        note += formatted("; tabulated, error at most %.2g of the force or pi w R",
                          table->errorBound());
    }
    return note;
}

}  // namespace asperity
