#pragma once

#include "app/window/recording/RunPlot.h"

#include <QStringList>
#include <QWidget>

#include <array>
#include <cstdint>
#include <optional>

class QAction;
class QLabel;
class QSlider;
class QToolButton;

namespace asperity {

class ChoiceBox;
class ReadingGrid;

/// Moments of a run that have a button.
enum class PlaybackStep : std::uint8_t { Start, SnapIn, Deepest, PullOff, End };
inline constexpr std::size_t kPlaybackSteps = 5;

/// The controls of a recording: its time, play and pause, speed, and buttons for its events.
class PlaybackBar : public QWidget {
    Q_OBJECT

public:
    /// The tick of each moment; none: the run has no such moment.
    using Steps = std::array<std::optional<int>, kPlaybackSteps>;

    explicit PlaybackBar(QWidget* parent = nullptr);

    /// A recording of so many ticks; 0: there is none, nothing can be done.
    void setRun(int ticks, const Steps& steps);
    /// The tick that is shown; a slider that is being dragged stays where it is.
    void setTick(int tick);
    void setPlaying(bool playing);
    void setComparing(bool comparing);
    /// Chooses a tenth of the speed of the run, or its own.
    void setSlow(bool slow);
    /// Adds a button for an entry of the menus that plays the last seconds of the run again.
    void addReplay(QAction& entry);
    /// Recorded seconds a second.
    [[nodiscard]] double speed() const;

Q_SIGNALS:
    void tickChosen(int tick);
    void playingChosen(bool playing);
    void compareRequested();
    /// The other run is not to be seen any more.
    void endComparisonRequested();
    void backRequested();

private:
    void buildSteps();
    QWidget* stepRow();
    QWidget* timeRow();

    QToolButton* play_;
    QSlider* time_;
    ChoiceBox* speed_;
    std::array<QToolButton*, kPlaybackSteps> buttons_{};
    Steps steps_{};
    QToolButton* replay_;
    QToolButton* compare_;
    QToolButton* alone_;
    QToolButton* back_;
};

/// A page on a recorded run: where it is, its force over time, the readings of the moment, and the
/// same of a second run with the difference of both.
class PlaybackPage : public QWidget {
    Q_OBJECT

public:
    /// Readings of a moment, for people.
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
    /// Difference of a second run.
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
