#pragma once

#include "core/scene/SceneFields.h"

#include <QObject>
#include <QSizeF>

#include <functional>
#include <optional>

class QGridLayout;
class QLabel;
class QLineEdit;
class QToolButton;
class QWidget;

namespace asperity {

class ChoiceBox;
class NumberBox;

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
    /// Of the scan, where the places of leveling begin [m].
    void setScanSize(const QSizeF& size);
    /// The values to choose from, where they are not the field's own.
    void setChoices(const std::vector<SceneChoice>& choices);
    /// Disables the row. @param reason that its tool tips say; empty: it works
    void refuse(const QString& reason);

Q_SIGNALS:
    void entered(const asperity::SceneValue& value);
    /// In place of entered(): steps and their places are one change.
    void levelingEntered(const asperity::LevelingSteps& steps,
                         const std::optional<asperity::LevelPoints>& places);
    /// The text says no such value.
    void refused(const QString& reason);

private:
    [[nodiscard]] QWidget* newControl(QWidget* parent);
    [[nodiscard]] QWidget* newNumber(QWidget* parent);
    [[nodiscard]] QWidget* newSwitch(QWidget* parent);
    [[nodiscard]] QWidget* newChoice(QWidget* parent);
    [[nodiscard]] QWidget* newText(QWidget* parent);
    [[nodiscard]] QWidget* newLeveling(QWidget* parent);
    void reset();
    void enterText(QLineEdit& line);
    void setMuted(bool muted);

    const SceneField& field_;
    std::vector<SceneChoice> choices_;
    std::function<void(const SceneDescription& scene)> showValue_;
    QLabel* caption_;
    QWidget* control_;
    QToolButton* reset_;
    QString shownText_;  ///< of a text, as it was shown last
    SceneDescription defaults_;
    bool muted_ = false;
};

}  // namespace asperity
