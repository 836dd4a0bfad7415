#pragma once

#include <optional>

namespace asperity {

/// Counts frames and returns how many there were in the last full second.
class FrameCounter {
public:
    /// One more frame at a time [s].
    void add(double now) {
        if (begin_ < 0.0) {
            begin_ = now;
            counted_ = 0;
        } else {
            ++counted_;
            ++frames_;
            time_ += now - latest_;
        }
        latest_ = now;
        if (now - begin_ >= 1.0) {
            rate_ = counted_ / (now - begin_);
            begin_ = now;
            counted_ = 0;
        }
    }

    /// The next frame comes after a rest that does not count.
    void rest() { begin_ = -1.0; }

    /// Frames a second over the last full second; none: there was no full second yet.
    [[nodiscard]] const std::optional<double>& rate() const { return rate_; }
    /// Frames a second over all the time that counts.
    [[nodiscard]] double overallRate() const {
        return time_ > 0.0 ? static_cast<double>(frames_) / time_ : 0.0;
    }

private:
    double begin_ = -1.0;   ///< of the second that is counted; < 0: none [s]
    double latest_ = -1.0;  ///< [s]
    int counted_ = 0;
    std::optional<double> rate_;
    double time_ = 0.0;  ///< between all frames [s]
    long frames_ = 0;
};

}  // namespace asperity
