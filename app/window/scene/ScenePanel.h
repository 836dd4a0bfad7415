#pragma once

#include "app/window/Stage.h"
#include "core/scene/SceneFieldChange.h"
#include "core/scene/SceneFields.h"

#include <QObject>
#include <QSizeF>
#include <QStringList>
#include <QWidget>

#include <functional>
#include <map>
#include <optional>
#include <vector>

class QVBoxLayout;
class QGridLayout;
class QLabel;
class QLineEdit;
class QToolButton;

namespace asperity {

class ChoiceBox;
class LibraryBar;
class NumberBox;
class ScenePanel;
class Section;

/// The page that shows all keys of the scene and changes them.
class ScenePanelControl : public Feature {
    Q_OBJECT

public:
    explicit ScenePanelControl(Stage& stage);

    [[nodiscard]] ScenePanel& panel() { return *panel_; }

private:
    void enter(const SceneField& field, const SceneValue& value);
    void level(const LevelingSteps& steps, const std::optional<LevelPoints>& points);
    void show();

    ScenePanel* panel_;
};

/// One key of a scene in a panel: its caption, a control that shows and takes its value, and a
/// button that gives it its default back. Where it has that, it is muted.
class SceneFieldRow : public QObject {
    Q_OBJECT

public:
    /// @param grid to which it adds a row
    SceneFieldRow(const SceneField& field, QGridLayout& grid, QWidget* parent);

    [[nodiscard]] const SceneField& field() const { return field_; }
    /// Emits nothing. @param defaults the same scene with all keys at their defaults
    void show(const SceneDescription& scene, const SceneDescription& defaults);
    /// Sets the size of the scan, for the first points of leveling [m].
    void setScanSize(const QSizeF& size);
    /// The values to choose from, where they are not the field's own.
    void setChoices(const std::vector<SceneChoice>& choices);
    /// Disables the row. @param reason that its tool tips say; empty: it works
    void refuse(const QString& reason);

Q_SIGNALS:
    void entered(const asperity::SceneValue& value);
    /// Instead of entered(): steps and their points are one change.
    void levelingEntered(const asperity::LevelingSteps& steps,
                         const std::optional<asperity::LevelPoints>& points);
    /// The text says no such value.
    void refused(const QString& reason);

private:
    [[nodiscard]] QWidget* newControl(QWidget* parent);
    [[nodiscard]] QWidget* newNumber(QWidget* parent);
    [[nodiscard]] QWidget* newSwitch(QWidget* parent);
    [[nodiscard]] QWidget* newChoice(QWidget* parent);
    [[nodiscard]] QWidget* newText(QWidget* parent);
    [[nodiscard]] QWidget* newLeveling(QWidget* parent);
    void showZero(const SceneDescription& scene);
    void reset();
    void enterText(QLineEdit& line);
    void setMuted(bool muted);

    const SceneField& field_;
    std::vector<SceneChoice> choices_;
    std::function<void(const SceneDescription& scene)> showValue_;
    QLabel* caption_;
    QWidget* control_;
    QToolButton* reset_;
    QSizeF scanSize_;    ///< [m]
    QString shownText_;  ///< of a text, as it was shown last
    SceneDescription defaults_;
    bool muted_ = false;
};

/// Every key of the scene but those of the haptics, in the units of a lab, a section each for what
/// they are about. Setters show a state and emit nothing.
class ScenePanel : public QWidget {
    Q_OBJECT

public:
    explicit ScenePanel(QWidget* parent = nullptr);

    /// @param defaults the same scene with all keys at their defaults
    void showScene(const SceneDescription& scene, const SceneDescription& defaults);
    /// Sets the size of the scan, for the points of leveling [m].
    void setScanSize(const QSizeF& size);
    /// The channels of the file that can be taken.
    void setChannels(const QStringList& names);
    [[nodiscard]] LibraryBar& materials() { return *materials_; }
    [[nodiscard]] LibraryBar& probes() { return *probes_; }
    /// Returns which quantities of the lever were measured.
    [[nodiscard]] LeverCalibration calibration() const;

Q_SIGNALS:
    void valueEntered(const asperity::SceneField& field, const asperity::SceneValue& value);
    void levelingEntered(const asperity::LevelingSteps& steps,
                         const std::optional<asperity::LevelPoints>& points);
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
