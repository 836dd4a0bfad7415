#pragma once

#include "core/surface/GivenScale.h"
#include "core/surface/ScaleGap.h"

#include <QDialog>

class QDialogButtonBox;

namespace asperity {

class ScaleForm;

/// Asks for the scale that a file does not hold, see ScaleForm. It closes with OK, which says what
/// was given, or with Cancel.
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
    [[nodiscard]] QDialogButtonBox* newButtons();

    ScaleForm* form_;
};

}  // namespace asperity
