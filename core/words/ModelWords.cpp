#include "core/words/ModelWords.h"

#include "core/FormattedText.h"

#include <algorithm>

namespace asperity {

namespace {

/// Two digits without a power of ten; what is not zero is not shown as zero.
std::string percent(double share) {
    constexpr double kMinShown = 1e-4;
    const double shown = share > 0.0 ? 100.0 * std::max(share, kMinShown) : 0.0;
    return formatted(shown < 99.5 ? "%.2g %%" : "%.0f %%", shown);
}

/// The terms that the law error is of.
std::string lawTerms(const SceneNeeds& needs) {
    std::string names;
    for (const ModelTerm term : needs.lawMisses) {
        names += (names.empty() ? "" : ", ") + std::string(nameOf(term));
    }
    return names;
}

}  // namespace

std::string forceErrorText(const SceneNeeds& needs) {
    if (!needs.measured) {
        return "error of the forces not measured";
    }
    std::string text =
        "forces within " + percent(needs.totalError()) + " of their rms in 97 ticks of 100";
    if (needs.lawError > 0.0) {
        text += ": " + percent(needs.wholeError) + " by what is left out, " +
                percent(needs.lawError) + " by what no contact law has beside the rest (" +
                lawTerms(needs) + ")";
    }
    return text;
}

std::string modelNote(const SceneNeeds& needs) {
    std::string out;
    for (const TermNeed& need : needs.terms) {
        const auto& misses = needs.lawMisses;
        if (!need.on && std::ranges::find(misses, need.term) == misses.end()) {
            out += (out.empty() ? "" : ", ") + std::string(nameOf(need.term));
        }
    }
    const std::string tolerance = formatted(" (tolerance %.2g %%)", 100.0 * needs.tolerance);
    return "model: " + forceErrorText(needs) + tolerance +
           (out.empty() ? ", nothing left out" : "; left out: " + out);
}

}  // namespace asperity
