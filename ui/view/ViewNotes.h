#pragma once

#include <string>
#include <vector>

namespace asperity {

/// What a view's notes depend on.
struct ViewNoteFacts {
    double heightScale = 1.0;
    bool hasPerspective = false;
    bool isFromBelow = false;       ///< the underside of the surface is seen
    bool missesTrueTip = false;     ///< its ghost is asked for, and the instrument does not know it
    bool hidesDeformation = false;  ///< the surface is drawn at rest
    bool showsLever = false;
    bool showsCap = false;   ///< only the lowest part of a large tip is drawn
    double tipRadius = 0.0;  ///< [m]
    double pixel = 0.0;      ///< of the scan [m]
    double width = 0.0;      ///< of the frame [m]
};

/// What a picture does not say by itself: a stretched height, coarse pixels.
[[nodiscard]] std::vector<std::string> viewNotes(const ViewNoteFacts& facts);

/// Of a tip above the view. @param gap to the surface [m]
[[nodiscard]] std::string tipAboveNote(double gap);

}  // namespace asperity
