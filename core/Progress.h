#pragma once

#include <exception>

namespace asperity {

/// Told how far a long piece of work has come; may ask for its end.
class Progress {
public:
    Progress() = default;
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    virtual ~Progress() = default;

    /// Called by the thread that started the work, a few dozen times in all.
    /// @param fraction of the work that is done, 0..1, never falling
    virtual void report(double fraction) = 0;
    [[nodiscard]] virtual bool isCanceled() const = 0;
};

/// Thrown out of a piece of work whose Progress was canceled.
class Canceled : public std::exception {
public:
    [[nodiscard]] const char* what() const noexcept override { return "canceled"; }
};

/// @param progress may be null
/// @throw Canceled
inline void reportTo(Progress* progress, double fraction) {
    if (progress == nullptr) {
        return;
    }
    if (progress->isCanceled()) {
        throw Canceled();
    }
    progress->report(fraction);
}

/// A step of a longer piece of work, from one fraction of it to another.
class ProgressPart : public Progress {
public:
    /// @param whole may be null; must outlive this
    ProgressPart(Progress* whole, double from, double to) : whole_(whole), from_(from), to_(to) {}

    void report(double fraction) override {
        if (whole_ != nullptr) {
            whole_->report(from_ + fraction * (to_ - from_));
        }
    }
    [[nodiscard]] bool isCanceled() const override {
        return whole_ != nullptr && whole_->isCanceled();
    }

private:
    Progress* whole_;
    double from_;
    double to_;
};

}  // namespace asperity
