#pragma once

#include "ui/panels/RunPanel.h"

#include <QWidget>

class QLabel;

namespace asperity {

/// How well the loop and the pictures keep their time: a line for the window's status bar.
class LoopStatusBar : public QWidget, public RunPanel {
public:
    explicit LoopStatusBar(QWidget* parent = nullptr);

    void setRateAsked(double rate);          ///< of the loop [Hz]
    void setFramesPerSecond(double frames);  ///< of the pictures [1/s]
    void clear() override;
    void rewind() override {}  // it shows the loop, whatever the tick
    void begin(const Scene& scene) override;
    void show(const Snapshot& snapshot) override;
    using QWidget::show;
    [[nodiscard]] ShownNumbers numbers(const Snapshot& snapshot) const override;

private:
    QLabel* addItem(const char* objectName, const QString& meaning, const QString& caption,
                    const QString& widest);

    double rateAsked_ = 0.0;        ///< [Hz]
    double framesPerSecond_ = 0.0;  ///< [1/s]
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
