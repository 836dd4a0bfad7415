#pragma once

#include "core/Progress.h"

#include <vtkAlgorithm.h>

namespace asperity {

/// Passes progress to ParaView's bar, and its request to abort back.
class AlgorithmProgress : public Progress {
public:
    explicit AlgorithmProgress(vtkAlgorithm& algorithm) : algorithm_(algorithm) {}

    void report(double fraction) override { algorithm_.UpdateProgress(fraction); }
    [[nodiscard]] bool isCanceled() const override { return algorithm_.GetAbortExecute() != 0; }

private:
    vtkAlgorithm& algorithm_;
};

}  // namespace asperity
