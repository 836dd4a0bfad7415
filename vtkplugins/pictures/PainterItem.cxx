#include "vtkplugins/pictures/PainterItem.h"

#include <vtkObjectFactory.h>

#include <utility>

namespace asperity {

vtkStandardNewMacro(PainterItem)

bool PainterItem::Paint(vtkContext2D* context) {
    Painter painter(context, oversampling_);
    draw_(painter);
    return true;
}

void PainterItem::setDraw(std::function<void(Painter&)> draw, double oversampling) {
    draw_ = std::move(draw);
    oversampling_ = oversampling;
    Modified();
}

}  // namespace asperity
