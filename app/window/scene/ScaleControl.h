#pragma once

#include "core/surface/GivenScale.h"

#include <QDialog>
#include <QPointer>
#include <QWidget>

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <tuple>

class QDialogButtonBox;
class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;

namespace asperity {

class Host;
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
    /// Returns the scale in the fields, as far as it is asked for; 0 where a field is empty.
    [[nodiscard]] GivenScale scale() const;

Q_SIGNALS:
    void given(GivenScale scale);

private:
    [[nodiscard]] QDialogButtonBox* newButtons();

    ScaleForm* form_;
};

/// Asks the user for the scale that a file does not hold, and suggests for the next scan of the
/// same type and pixels what was given for the last one, while the session lasts.
class ScaleControl : public QObject {
    Q_OBJECT

public:
    using Kind = std::tuple<std::string, int, int>;  ///< extension, columns, rows

    explicit ScaleControl(Host& host) : host_(host) {}

    /// Opens the dialog; the window stays usable. One that is open closes.
    void ask(const std::filesystem::path& file, const ScaleGap& gap);
    /// Returns the scale given for the last scan of this type and these pixels; none: none was.
    [[nodiscard]] std::optional<GivenScale> suggestion(const std::filesystem::path& file,
                                                       const ScaleGap& gap) const;
    /// To be suggested for the next one.
    void learn(const std::filesystem::path& file, const ScaleGap& gap, const GivenScale& scale);
    /// Nothing comes of the dialog that is open.
    void withdraw();

Q_SIGNALS:
    void given(GivenScale scale);
    void refused();

private:
    Host& host_;
    QPointer<ScaleDialog> dialog_;
    std::map<Kind, GivenScale> known_;
};

class LengthBox;

/// Fields for the scale that a file does not hold: size of the scan, height of a value of 1, or
/// both. Nothing is assumed: they are empty until they are filled in.
class ScaleForm : public QWidget {
    Q_OBJECT

public:
    /// @param orientation of size and height: one below the other, or side by side
    explicit ScaleForm(Qt::Orientation orientation, QWidget* parent = nullptr);

    /// Sets what is asked for: nothing else can be filled in. Another gap than the present one
    /// empties the fields.
    void setGap(const ScaleGap& gap);
    [[nodiscard]] const ScaleGap& gap() const { return gap_; }
    /// Fills in what was given for another scan.
    void suggest(const GivenScale& scale);
    /// Returns the scale in the fields, as far as it is asked for; 0 where a field is empty.
    [[nodiscard]] GivenScale scale() const;
    /// Returns whether all that is asked for is given.
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
    QWidget* height_;  ///< same
    LengthBox* sizeX_;
    LengthBox* sizeY_;
    QComboBox* sizeUnit_;
    QCheckBox* square_;
    LengthBox* heightPerValue_;
    QComboBox* heightUnit_;
    QLabel* pixel_;
};

}  // namespace asperity
