#pragma once

#include "core/Progress.h"

#include <gtest/gtest.h>

namespace asperity::test {

/// Cancels once it has had so many reports, and expects them to grow from 0 to 1.
class CanceledAfter : public Progress {
public:
    explicit CanceledAfter(int reports) : left_(reports) {}

    void report(double fraction) override {
        EXPECT_GE(fraction, last_);
        EXPECT_LE(fraction, 1.0);
        last_ = fraction;
        --left_;
    }
    [[nodiscard]] bool isCanceled() const override { return left_ <= 0; }

private:
    int left_;
    double last_ = 0.0;
};

}  // namespace asperity::test
