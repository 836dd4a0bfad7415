#pragma once

#include "ui/panels/MapTool.h"
#include "ui/panels/OverviewMap.h"

namespace asperity {

/// Has the switch of a page activate its tool on the whole scan, and show whether it is active.
template <typename Page>
void bindTool(OverviewMap& map, MapTool& tool, Page& page, void (Page::*chosen)(bool),
              void (Page::*show)(bool)) {
    map.addTool(tool);
    QObject::connect(&page, chosen, &tool, [&map, &tool](bool active) {
        if (active) {
            map.activate(&tool);
        } else if (map.activeTool() == &tool) {
            map.activate(nullptr);
        }
    });
    QObject::connect(
        &map, &OverviewMap::toolActivated, &page,
        [&page, &tool, show](const MapTool* active) { (page.*show)(active == &tool); });
}

}  // namespace asperity
