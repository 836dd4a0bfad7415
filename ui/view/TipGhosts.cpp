#include "ui/view/TipGhosts.h"

#include "ui/Theme.h"

#include <QObject>

namespace asperity {

void TipGhosts::show(const ViewOptions& options, const std::optional<Vector3>& commanded,
                     const std::optional<Vector3>& trueTip, GhostStyle style) {
    names_.clear();
    const auto show = [&](GhostLayer& ghost, bool isOn, const std::optional<Vector3>& apex,
                          const Color& color, const QString& name) {
        if (!isOn || !apex || !apex->allFinite()) {
            ghost.hide();
            return;
        }
        style.color = color;
        ghost.show(*apex, style);
        names_.push_back({ghost.labelPlace(), name.toStdString(), color});
    };
    show(commanded_, options.commandedTip, commanded, theme::palette().commanded,
         QObject::tr("commanded"));
    show(true_, options.trueTip, trueTip, theme::palette().trueTip, QObject::tr("true tip"));
}

}  // namespace asperity
