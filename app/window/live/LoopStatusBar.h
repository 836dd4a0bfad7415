#pragma once

#include "ui/shell/RunPanel.h"

#include <QWidget>

#include <optional>
#include <vector>

class QLabel;

namespace asperity {

/// Part of the status bar that tells in one word whether the loop keeps its rate; on request it
/// shows the timing of the loop and of the pictures, too.
class LoopStatusBar : public QWidget, public RunPanel {
public:
    explicit LoopStatusBar(QWidget* parent = nullptr);

    void setRateAsked(double rate);  ///< of the loop [Hz]
    /// Sets the rate of the pictures [1/s]; none: not known yet.
    void setFramesPerSecond(const std::optional<double>& frames);
    /// Sets whether all of the timing is shown: as much of it as fits.
    void setDetailed(bool detailed);
    void clear() override;
    void rewind() override {}  // it shows the loop, whatever the tick
    void begin(const Scene& scene) override;
    void show(const Snapshot& snapshot) override;
    using QWidget::show;
    [[nodiscard]] ShownNumbers numbers(const Snapshot& snapshot) const override;

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    /// A number with its caption.
    struct Item {
        QLabel* caption;
        QLabel* value;
    };

    QLabel* addItem(const char* objectName, const QString& meaning, const QString& caption,
                    const QString& widest);
    void showState(const LoopStatistics& statistics);
    void showItems();

    double rateAsked_ = 0.0;                 ///< [Hz]
    std::optional<double> framesPerSecond_;  ///< [1/s]
    bool isDetailed_ = false;
    long overrunsThen_ = 0;  ///< of the loop, when a second began
    long ticksThen_ = 0;     ///< same
    bool isLate_ = false;    ///< in the last whole second
    QLabel* state_;
    std::vector<Item> items_;  ///< in the order of the line
    QLabel* rate_;
    QLabel* ticks_;
    QLabel* tickTime_;
    QLabel* lateness_;
    QLabel* overruns_;
    QLabel* lost_;
    QLabel* scheduling_;
    QLabel* frames_;
};

}  // namespace asperity
