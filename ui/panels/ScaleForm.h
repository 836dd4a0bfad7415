#pragma once

#include "core/surface/GivenScale.h"
#include "core/surface/ScaleGap.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;

namespace asperity {

class LengthBox;

/// Fields for the scale that a file does not hold: size of the scan, height of a value of 1, or
/// both. Nothing is assumed: they are empty until they are filled in.
class ScaleForm : public QWidget {
    Q_OBJECT

public:
    /// @param orientation of size and height: one below the other, or side by side
    explicit ScaleForm(Qt::Orientation orientation, QWidget* parent = nullptr);

    /// What is asked for: nothing else can be filled in. Another gap than the present one empties
    /// the fields.
    void setGap(const ScaleGap& gap);
    [[nodiscard]] const ScaleGap& gap() const { return gap_; }
    /// Fills in what was given for another scan.
    void suggest(const GivenScale& scale);
    /// What the fields say of what is asked for; 0 where a field is empty.
    [[nodiscard]] GivenScale scale() const;
    /// Whether all that is asked for is given.
    [[nodiscard]] bool isComplete() const;

Q_SIGNALS:
    /// scale() or isComplete() may be others.
    void changed();

private:
    void addSize(QGridLayout& grid);
    void addHeight(QGridLayout& grid);
    void connectInputs();
    /// Makes the pixels square by the other side.
    void follow(const LengthBox& entered);
    void showState();

    ScaleGap gap_;
    QLabel* missing_;
    QWidget* size_;    ///< with all of its fields
    QWidget* height_;  ///< likewise
    LengthBox* sizeX_;
    LengthBox* sizeY_;
    QComboBox* sizeUnit_;
    QCheckBox* square_;
    LengthBox* heightPerValue_;
    QComboBox* heightUnit_;
    QLabel* pixel_;
};

}  // namespace asperity
