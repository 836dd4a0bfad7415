#include "app/session/ParameterControl.h"

#include "ui/CoreWords.h"
#include "ui/panels/ParameterPanel.h"
#include "ui/window/MainWindow.h"

namespace asperity {

ParameterControl::ParameterControl(MainWindow& window, RunControl& runs, SceneEdits& edits)
    : window_(window), edits_(edits) {
    connect(&window.parameters(), &ParameterPanel::parameterEntered, this,
            &ParameterControl::change);
    connect(&runs, &RunControl::begun, this, &ParameterControl::show);
    connect(&edits, &SceneEdits::changed, this, &ParameterControl::show);
}

void ParameterControl::change(SceneParameter parameter, double value) {
    if (const SceneDescription* const now = edits_.wanted()) {
        const auto& traits = *rowOf(parameter);
        edits_.change(tr("%1: %2").arg(coreWords(traits.caption)).arg(value / traits.unit),
                      withParameter(*now, parameter, value), QString::fromUtf8(traits.key));
    }
}

void ParameterControl::show() {
    if (const SceneDescription* const scene = edits_.wanted()) {
        window_.parameters().showScene(*scene);
    }
}

}  // namespace asperity
