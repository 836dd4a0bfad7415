#pragma once

#include "core/io/curves/StoredCurves.h"

#include <QDialog>

#include <filesystem>

class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace asperity {

/// Asks which column of a text table is what, over a preview of its first lines.
class CurveColumnsDialog : public QDialog {
    Q_OBJECT

public:
    CurveColumnsDialog(std::filesystem::path file, const CurveReadOptions& options,
                       QWidget* parent);

    /// What was said last that can be read.
    [[nodiscard]] const CurveReadOptions& options() const { return options_; }

private:
    /// Tries to read the table so.
    void take();

    std::filesystem::path file_;
    CurveReadOptions options_;
    QLineEdit* columns_;
    QSpinBox* skipped_;
    QLabel* found_;
    QPushButton* accept_;
};

}  // namespace asperity
