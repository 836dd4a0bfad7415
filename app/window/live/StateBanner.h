#pragma once

#include "core/deformation/HalfSpaceModel.h"
#include "core/haptics/VirtualRun.h"
#include "core/scene/Validity.h"
#include "ui/shell/RunPanel.h"

#include <QFrame>
#include <QStringList>

#include <array>
#include <optional>
#include <vector>

class QLabel;
class QPushButton;

namespace asperity {

/// Validity flags that a user shall see. One of a single tick stays long enough to be read, but
/// one of a contact goes with it; one that noisy signals raise counts where most ticks have it.
class ShownFlags {
public:
    ShownFlags() { clear(); }

    void clear() noexcept;
    /// Every tick, in order.
    void take(const TickSample& sample) noexcept;
    /// @param index into kValidityTraits @param latest the newest tick, taken or not
    [[nodiscard]] bool isShown(std::size_t index, const TickSample& latest) const;

private:
    struct Seen {
        double last = 0.0;    ///< time of the last tick that had it [s]
        double share = 0.0;   ///< of the last ticks
        bool inMost = false;  ///< of them, with hysteresis
    };

    std::array<Seen, kValidityFlagCount> seen_;
    std::optional<double> time_;  ///< of the newest tick taken [s]
};

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
    /// Sets the half-space's result for the contact, shown from the next tick on: its own force
    /// beside the law's, or that it does not hold; null: nothing.
    void setHalfSpace(const HalfSpaceAnswer* answer);
    /// Sets whether the loop adds energy of its own to a force-feedback device; shown from the next
    /// tick on.
    void setEnergyGiven(bool given) { energyGiven_ = given; }
    /// The run is paused, or continues.
    void setPaused(bool paused);
    /// Sets the moment of a recording that is shown, since its first tick [s]; none: it is live.
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
