#pragma once

#include "ui/window/ExportChoices.h"

#include <QDialog>

class QCheckBox;
class QComboBox;
class QDialogButtonBox;
class QFormLayout;
class QImage;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace asperity {

class ExportPicture;
class FilmFields;

/// Chooses what of the window goes to a file, and how: choices on the left, on the right a preview.
/// It only asks: who draws and writes is behind it.
class ExportDialog : public QDialog {
    Q_OBJECT

public:
    ExportDialog(ExportOffer offer, ExportChoices choices, QWidget* window);

    [[nodiscard]] const ExportChoices& choices() const { return choices_; }
    /// The format of the present subject, an extension without its dot.
    [[nodiscard]] QString format() const;

    /// The picture as it will be.
    void showPreview(const QImage& picture);
    /// In place of a picture, what the file will hold.
    void showWords(const QString& words);
    /// The file that will be written; empty: the name is none.
    void showFile(const QString& path);
    /// Why nothing can be written, a sentence; empty: it can.
    void showFailure(const QString& reason);
    /// Room of the preview [pixel].
    [[nodiscard]] QSize previewRoom() const;

    [[nodiscard]] QSize sizeHint() const override;

Q_SIGNALS:
    /// By the user: choices() are others.
    void changed();
    void exportRequested();
    void copyRequested();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    [[nodiscard]] QWidget* newForm();
    void addPicture(QFormLayout& form);
    void addParts(QFormLayout& form);
    void addPlace(QFormLayout& form);
    [[nodiscard]] QWidget* newPreview();
    [[nodiscard]] QDialogButtonBox* newButtons();
    void fill();
    void connectInputs();
    void showFormats();
    void chooseSize();
    void take();
    void showState();
    void browse();

    ExportOffer offer_;
    ExportChoices choices_;
    QComboBox* subject_ = nullptr;
    QComboBox* format_ = nullptr;
    QComboBox* column_ = nullptr;
    QSpinBox* width_ = nullptr;
    QSpinBox* height_ = nullptr;
    QSpinBox* dpi_ = nullptr;
    QCheckBox* transparent_ = nullptr;
    QCheckBox* bars_ = nullptr;
    QCheckBox* labels_ = nullptr;
    QCheckBox* clean_ = nullptr;
    FilmFields* film_ = nullptr;
    QLineEdit* folder_ = nullptr;
    QLineEdit* name_ = nullptr;
    QLabel* file_ = nullptr;
    ExportPicture* picture_ = nullptr;
    QLabel* message_ = nullptr;
    QPushButton* copy_ = nullptr;
    QPushButton* export_ = nullptr;
};

}  // namespace asperity
