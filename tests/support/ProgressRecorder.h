#pragma once

#include "core/Progress.h"

#include <vector>

namespace asperity::test {

/// Keeps what it is told, and cancels once it has been told of this fraction.
class ProgressRecorder : public Progress {
public:
    explicit ProgressRecorder(double cancelAt) : cancelAt_(cancelAt) {}

    void report(double fraction) override { fractions.push_back(fraction); }
    [[nodiscard]] bool isCanceled() const override {
        return !fractions.empty() && fractions.back() >= cancelAt_;
    }

    std::vector<double> fractions;

private:
    double cancelAt_;
};

}  // namespace asperity::test
