#pragma once

#include "core/scene/SceneParameter.h"

#include <QWidget>

#include <map>

class QGridLayout;

namespace asperity {

class NumberBox;

/// Tip, lever and material of the scene in numbers that a user can change, a window of its own.
/// Setters show a state and emit nothing.
class ParameterPanel : public QWidget {
    Q_OBJECT

public:
    explicit ParameterPanel(QWidget* parent = nullptr);

    void showScene(const SceneDescription& scene);

Q_SIGNALS:
    /// @param value [SI]
    void parameterEntered(asperity::SceneParameter parameter, double value);

private:
    void addRow(QGridLayout& grid, const SceneParameterTraits& traits);

    std::map<SceneParameter, NumberBox*> boxes_;
};

}  // namespace asperity
