#pragma once

#include "core/surface/leveling/LevelingStep.h"

#include <QSizeF>
#include <QWidget>

#include <array>
#include <optional>

class QListWidget;
class QToolButton;
class QVBoxLayout;

namespace asperity {

class NumberBox;

/// The steps that level a scan, in their order: add, remove, move up and down. For three_point the
/// three points, too.
class LevelingEditor : public QWidget {
    Q_OBJECT

public:
    explicit LevelingEditor(QWidget* parent = nullptr);

    /// @param size of the scan [m]: where the points of three_point begin; empty: not known, so
    ///             that three_point cannot be added
    void setScanSize(const QSizeF& size);
    /// @param points of three_point
    void setLeveling(const LevelingSteps& steps, const std::optional<LevelPoints>& points);
    [[nodiscard]] const LevelingSteps& steps() const { return steps_; }
    [[nodiscard]] const std::optional<LevelPoints>& points() const { return points_; }

Q_SIGNALS:
    /// The user has changed steps() or points().
    void edited();

private:
    [[nodiscard]] QWidget* newButtons();
    [[nodiscard]] QToolButton* newButton(const char* name, const QString& text, const QString& tip);
    [[nodiscard]] QWidget* newPointFields();
    void add(LevelingStep step);
    void remove();
    void move(int by);
    void enterPoints();
    /// Shows steps and points. @param row of the list that is chosen then
    void showSteps(int row);
    void showButtons();

    LevelingSteps steps_;
    std::optional<LevelPoints> points_;
    QSizeF size_;
    QListWidget* list_;
    QToolButton* add_ = nullptr;
    QToolButton* remove_ = nullptr;
    QToolButton* up_ = nullptr;
    QToolButton* down_ = nullptr;
    QWidget* pointFields_ = nullptr;
    std::array<NumberBox*, 6> boxes_{};  ///< x, y of each point [µm]
};

}  // namespace asperity
