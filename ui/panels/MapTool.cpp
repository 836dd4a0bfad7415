#include "ui/panels/MapTool.h"

namespace asperity {

Qt::CursorShape MapTool::cursor(const MapPointer& /*pointer*/, const OverviewMap& /*map*/) const {
    return Qt::CrossCursor;
}

QString MapTool::hint() const { return {}; }

}  // namespace asperity
