#pragma once

#include "core/surface/GivenScale.h"
#include "core/surface/ScaleGap.h"

#include <QDialog>

class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;
class QPushButton;

namespace asperity {

class LengthBox;

/// Asks for the scale that a file does not hold: size of the scan, height of a value of 1, or both.
/// Nothing is assumed: its fields are empty until they are filled in. It closes with OK, which
/// says what was given, or with Cancel.
class ScaleDialog : public QDialog {
    Q_OBJECT

public:
    /// @param file its name
    /// @param gap  what is asked for
    ScaleDialog(const QString& file, const ScaleGap& gap, QWidget* window);

    /// Fills in what was given for another scan.
    void suggest(const GivenScale& scale);
    /// What the fields say of what is asked for; 0 where a field is empty.
    [[nodiscard]] GivenScale scale() const;

Q_SIGNALS:
    void given(GivenScale scale);

private:
    void addSize(QGridLayout& grid);
    void addHeight(QGridLayout& grid);
    void addButtons(QGridLayout& grid);
    void connectInputs();
    [[nodiscard]] bool isComplete() const;
    /// Makes the pixels square by the other side.
    void follow(const LengthBox& entered);
    void showState();

    ScaleGap gap_;
    LengthBox* sizeX_;
    LengthBox* sizeY_;
    QComboBox* sizeUnit_;
    QCheckBox* square_;
    LengthBox* height_;
    QComboBox* heightUnit_;
    QLabel* pixel_;
    QPushButton* ok_;
};

}  // namespace asperity
