#pragma once

namespace asperity {

/// Counts frames and says how many there were in the last full second.
class FrameCounter {
public:
    /// One more frame at a time [s].
    void add(double now) {
        ++all_;
        ++counted_;
        if (begin_ < 0.0) {
            begin_ = now;
            first_ = now;
            counted_ = 0;
        }
        latest_ = now;
        if (now - begin_ >= 1.0) {
            rate_ = counted_ / (now - begin_);
            begin_ = now;
            counted_ = 0;
        }
    }

    /// Frames a second over the last full second.
    [[nodiscard]] double rate() const { return rate_; }
    /// Frames a second over all the time.
    [[nodiscard]] double overallRate() const {
        return latest_ > first_ ? static_cast<double>(all_ - 1) / (latest_ - first_) : 0.0;
    }

private:
    double begin_ = -1.0;  ///< of the second that is counted [s]
    double first_ = 0.0;   ///< [s]
    double latest_ = 0.0;  ///< [s]
    long all_ = 0;
    int counted_ = 0;
    double rate_ = 0.0;
};

}  // namespace asperity
