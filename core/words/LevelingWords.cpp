#include "core/words/LevelingWords.h"

#include "core/FormattedText.h"
#include "core/SiFormat.h"

namespace asperity {

namespace {

std::string slopesText(const PlaneFit& plane) {
    return formatted("slopes %+.4g along x and %+.4g along y", plane.slopeX, plane.slopeY);
}

std::string scarsText(std::size_t pixels) {
    return pixels == 0
               ? "no scars found"
               : std::to_string(pixels) + (pixels == 1 ? " pixel of scars" : " pixels of scars") +
                     " interpolated and marked as filled";
}

std::string sentenceOf(const RemovedByStep& removed) {
    switch (removed.step) {
    case LevelingStep::Plane:
        return "plane with " + slopesText(removed.plane) + " removed";
    case LevelingStep::Rows:
        return "the median of each row and the mean removed (medians spread by " +
               formatSi(removed.shiftSpread, "m") + ")";
    case LevelingStep::ThreePoint:
        return "plane through three places with " + slopesText(removed.plane) +
               " removed; they lie at height 0";
    case LevelingStep::Facet:
        return "plane of the prevailing facets with " + slopesText(removed.plane) +
               " and the mean removed";
    case LevelingStep::Quadratic:
        return "polynomial of second degree removed: " + slopesText(removed.plane) +
               formatted(" at the center, second derivatives %+.4g along x, %+.4g along y, %+.4g "
                         "mixed [1/m]",
                         removed.bendX, removed.bendY, removed.twist);
    case LevelingStep::MedianOfDifferences:
        return "rows shifted by the median of differences, trend along y kept (shifts spread by " +
               formatSi(removed.shiftSpread, "m") + ")";
    case LevelingStep::Scars:
        return scarsText(removed.pixels);
    case LevelingStep::Zero:
        return "lowest height, " + formatSi(removed.plane.mean, "m") + ", set to 0";
    }
    return keyOf(removed.step);
}

}  // namespace

std::vector<std::string> levelingNotes(const std::vector<RemovedByStep>& removed) {
    if (removed.empty()) {
        return {"leveling: none, heights as the file gives them"};
    }
    if (removed.size() == 1) {
        const bool isPlane = removed.front().step == LevelingStep::Plane;
        return {"leveling: " + sentenceOf(removed.front()) +
                (isPlane ? " (--level none keeps it)" : "")};
    }
    std::vector<std::string> notes;
    for (const RemovedByStep& one : removed) {
        notes.push_back(formatted("leveling, step %zu of %zu: ", notes.size() + 1, removed.size()) +
                        sentenceOf(one));
    }
    return notes;
}

}  // namespace asperity
