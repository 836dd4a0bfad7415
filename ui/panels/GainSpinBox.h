#pragma once

#include "ui/panels/NumberBox.h"

namespace asperity {

/// A number box for gains, which run over many powers of ten: steps go 1, 2, 5, 10, ...
class GainSpinBox : public NumberBox {
public:
    /// @param low, high limits, both > 0
    GainSpinBox(double low, double high, QWidget* parent = nullptr);

    void stepBy(int steps) override;
};

}  // namespace asperity
