#pragma once

#include "core/scene/SceneFieldChange.h"

#include <QSizeF>
#include <QStringList>
#include <QWidget>

#include <map>
#include <optional>
#include <vector>

class QVBoxLayout;

namespace asperity {

class ChoiceBox;
class LibraryBar;
class SceneFieldRow;
class Section;

/// Every key of the scene but those of the haptics, in the units of a lab, a section each for what
/// they are about. Setters show a state and emit nothing.
class ScenePanel : public QWidget {
    Q_OBJECT

public:
    explicit ScenePanel(QWidget* parent = nullptr);

    /// @param defaults the same scene with all keys at their defaults
    void showScene(const SceneDescription& scene, const SceneDescription& defaults);
    /// Of the scan, for the places of leveling [m].
    void setScanSize(const QSizeF& size);
    /// The channels of the file that can be taken.
    void setChannels(const QStringList& names);
    [[nodiscard]] LibraryBar& materials() { return *materials_; }
    [[nodiscard]] LibraryBar& probes() { return *probes_; }
    /// What was measured of the lever.
    [[nodiscard]] LeverCalibration calibration() const;

Q_SIGNALS:
    void valueEntered(const asperity::SceneField& field, const asperity::SceneValue& value);
    void levelingEntered(const asperity::LevelingSteps& steps,
                         const std::optional<asperity::LevelPoints>& places);
    void refused(const QString& reason);  ///< a text says no value of its key
    void openRequested();                 ///< another scan
    void fidelityRequested();             ///< what the terms of the model cost

private:
    [[nodiscard]] Section& newSection(SceneGroup group);
    void addRows();
    void addOpening(Section& section);
    void addCalibration(Section& section);
    void addFidelityLink(Section& section);

    QWidget* page_;  ///< that holds all; disabled without a scene
    QVBoxLayout* column_ = nullptr;
    LibraryBar* materials_;
    LibraryBar* probes_;
    ChoiceBox* calibration_;
    std::map<SceneGroup, Section*> sections_;
    std::vector<SceneFieldRow*> rows_;
};

}  // namespace asperity
