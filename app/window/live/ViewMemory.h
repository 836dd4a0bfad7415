#pragma once

#include <QVariantMap>

namespace asperity {

class LivePanels;

/// Has the views look as `kept` says: colors, ranges, what is drawn, the second view. What cannot
/// be read stays as it is.
void restoreViews(LivePanels& live, const QVariantMap& kept);
/// Adds how the views look now. Pinned ranges are of a scan, and are not kept.
void keepViews(LivePanels& live, QVariantMap& kept);

/// Has the large view look at its scene from where and as wide as `kept` says, and pins ranges of
/// colors.
void restoreViewpoint(LivePanels& live, const QVariantMap& kept);
/// Adds from where the large view looks at its scene, how wide, and which ranges are pinned.
void keepViewpoint(LivePanels& live, QVariantMap& kept);

}  // namespace asperity
