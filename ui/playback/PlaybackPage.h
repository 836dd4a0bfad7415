#pragma once

#include "ui/playback/PlaybackBar.h"
#include "ui/playback/RunPlot.h"

#include <QStringList>

class QLabel;

namespace asperity {

class ReadingGrid;

/// A page on a recorded run: where it is, its force over time, the readings of the moment, and the
/// same of a second run with the difference of both.
class PlaybackPage : public QWidget {
    Q_OBJECT

public:
    /// What is read of a moment, for people.
    struct Readings {
        QString time;
        QString force;
        QString distance;  ///< with its name: "gap 3.2 nm"
        QString state;
    };
    /// A run as it is drawn.
    struct Curves {
        QString name;
        QVector<QPointF> force;     ///< over time [N, s]
        QVector<QPointF> distance;  ///< force over indentation [N, m]
    };
    /// By how much a second run differs.
    struct Comparison {
        QString name;  ///< of the first run, beside the other one
        Curves other;
        QVector<QPointF> difference;  ///< over time [N, s]
        QString mean;
        QString rms;
        QString largest;
        QString overlap;
        QStringList differs;  ///< in what else the runs differ
    };

    explicit PlaybackPage(QWidget* parent = nullptr);

    [[nodiscard]] PlaybackBar& bar() { return *bar_; }
    /// @param ticks 0: there is no recording
    void setRun(int ticks, const PlaybackBar::Steps& steps, const Curves& curves);
    /// The moment that is shown. @param time [s] @param indentation [m] @param force normal [N]
    void showMoment(int tick, const Readings& readings, double time, double indentation,
                    double force);
    /// None: the recording is shown alone.
    void setComparison(const std::optional<Comparison>& comparison);

    [[nodiscard]] RunPlot& forcePlot() { return *force_; }
    [[nodiscard]] RunPlot& distancePlot() { return *distance_; }
    [[nodiscard]] RunPlot& differencePlot() { return *difference_; }
    [[nodiscard]] ReadingGrid& readings() { return *readings_; }
    [[nodiscard]] ReadingGrid& comparison() { return *comparison_; }

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void buildReadings();
    void showDifferences();
    void showNames();
    void showLines();

    PlaybackBar* bar_;
    RunPlot* force_;
    RunPlot* difference_;
    RunPlot* distance_;
    ReadingGrid* readings_;
    ReadingGrid* comparison_;
    QLabel* names_;  ///< of the two runs, in the colors of their lines
    QLabel* differs_;
    Curves curves_;
    std::optional<Comparison> other_;
};

}  // namespace asperity
