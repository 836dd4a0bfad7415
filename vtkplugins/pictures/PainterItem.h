#pragma once

#include "vtkplugins/pictures/Painter.h"

#include <vtkContextItem.h>

#include <functional>

namespace asperity {

/// Lets a function paint over a view, every time that the view is drawn.
class PainterItem : public vtkContextItem {
public:
    static PainterItem* New();
    PainterItem(const PainterItem&) = delete;
    void operator=(const PainterItem&) = delete;
    vtkTypeMacro(PainterItem, vtkContextItem)

    bool Paint(vtkContext2D* context) override;

    /// @param oversampling drawn pixels per pixel of the painter, along each side
    void setDraw(std::function<void(Painter&)> draw, double oversampling);

protected:
    PainterItem() = default;
    ~PainterItem() override = default;

private:
    std::function<void(Painter&)> draw_;
    double oversampling_ = 1.0;
};

}  // namespace asperity
