#pragma once

#include "core/deformation/HalfSpaceAnswer.h"
#include "core/scene/Validity.h"
#include "ui/panels/RunPanel.h"
#include "ui/panels/ShownFlags.h"

#include <QFrame>
#include <QStringList>

#include <optional>
#include <vector>

class QLabel;
class QPushButton;

namespace asperity {

/// One line of at most 60 characters that always shows in words and color where the tip is, whether
/// forces act, what went wrong, and the most severe reason to doubt a result. All else is in its
/// tool tip, which a click shows, too. Its height never changes.
class StateBanner : public QFrame, public RunPanel {
    Q_OBJECT

public:
    explicit StateBanner(QWidget* parent = nullptr);

    void clear() override;
    /// The flags, so that one that comes and goes can be read.
    void take(const TickSample& sample) noexcept override;
    void show(const Snapshot& snapshot) override;
    using QWidget::show;
    /// What the half-space says of the contact, from the next tick on: its own force beside the
    /// law's, or that it does not hold; null: nothing.
    void setHalfSpace(const HalfSpaceAnswer* answer);
    /// Whether a force-feedback device is given energy that nobody put in; shown from the next tick
    /// on.
    void setEnergyGiven(bool given) { energyGiven_ = given; }
    /// The run stands still, or goes on.
    void setPaused(bool paused);
    /// What is shown is a moment of a recording, in the time of its run [s]; none: it is live.
    void setRecorded(const std::optional<double>& time);

Q_SIGNALS:
    /// The user resets the fault.
    void rearmRequested();

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;

private:
    /// A reason to doubt a result, or a warning.
    struct Caution {
        QString brief;
        QString words;
        Severity severity;
    };

    void showLine();
    void showColor();
    /// The most important part first.
    [[nodiscard]] QStringList stateWords() const;
    /// The most severe one first, of equally severe ones that which may change the force most.
    [[nodiscard]] std::vector<Caution> cautions() const;
    void showDetails(const QStringList& state, const std::vector<Caution>& cautions);
    [[nodiscard]] QColor stateColor() const;

    Snapshot latest_;
    bool hasRun_ = false;
    bool paused_ = false;
    std::optional<double> recorded_;
    bool energyGiven_ = false;
    ShownFlags shown_;
    QColor shownColor_;
    QString details_;     ///< all there is to say
    QString halfSpace_;   ///< its force beside the law's
    QString notHolding_;  ///< why it is not shown
    QLabel* state_;
    QLabel* flags_;
    QPushButton* rearm_;
};

}  // namespace asperity
