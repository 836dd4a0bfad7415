#pragma once

#include "core/Vector.h"

#include <QObject>

#include <optional>

namespace asperity {

class OverviewMap;
class SecondView;
class ZoomView;

/// One cross-hair for all views: where the pointer is in one of them, all show the place and what
/// is read there.
class CrossHairLink : public QObject {
public:
    /// All outlive this object.
    CrossHairLink(ZoomView& view, SecondView& second, OverviewMap& map);

    /// World x, y [m]; none: the pointer is over no view.
    [[nodiscard]] const std::optional<Vector2>& place() const { return place_; }

    /// Off, no view shows any.
    void setOn(bool on);

private:
    template <class View>
    void follow(View& view);
    void point(const std::optional<Vector2>& place);
    void showInOthers();

    ZoomView& view_;
    SecondView& second_;
    OverviewMap& map_;
    std::optional<Vector2> place_;
    bool isOn_ = true;
};

}  // namespace asperity
