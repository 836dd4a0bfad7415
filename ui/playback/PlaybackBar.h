#pragma once

#include <QWidget>

#include <array>
#include <cstdint>
#include <optional>

class QSlider;
class QToolButton;

namespace asperity {

class ChoiceBox;

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
    /// Whether another run is overlaid.
    void setComparing(bool comparing);
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
    QToolButton* compare_;
    QToolButton* alone_;
    QToolButton* back_;
};

}  // namespace asperity
