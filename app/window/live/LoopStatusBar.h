#pragma once

#include "ui/shell/RunPanel.h"

#include <QWidget>

#include <optional>

class QLabel;

namespace asperity {

/// Timing of the loop and of the pictures: a line for the window's status bar.
class LoopStatusBar : public QWidget, public RunPanel {
public:
    explicit LoopStatusBar(QWidget* parent = nullptr);

    void setRateAsked(double rate);  ///< of the loop [Hz]
    /// Sets the rate of the pictures [1/s]; none: not known yet.
    void setFramesPerSecond(const std::optional<double>& frames);
    void clear() override;
    void rewind() override {}  // it shows the loop, whatever the tick
    void begin(const Scene& scene) override;
    void show(const Snapshot& snapshot) override;
    using QWidget::show;
    [[nodiscard]] ShownNumbers numbers(const Snapshot& snapshot) const override;

private:
    QLabel* addItem(const char* objectName, const QString& meaning, const QString& caption,
                    const QString& widest);

    double rateAsked_ = 0.0;                 ///< [Hz]
    std::optional<double> framesPerSecond_;  ///< [1/s]
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
