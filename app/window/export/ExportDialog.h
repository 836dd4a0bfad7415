#pragma once

#include "app/window/export/ExportChoices.h"

#include <QDialog>
#include <QImage>
#include <QObject>
#include <QString>
#include <QWidget>

class QCheckBox;
class QComboBox;
class QDialogButtonBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;
class QDoubleSpinBox;

namespace asperity {

class ExportPicture;

/// The rows of a form that choose a film: which recording, which part of it, in which view, how
/// fast.
class FilmFields : public QObject {
    Q_OBJECT

public:
    /// Adds the rows, whose widgets own this.
    FilmFields(QFormLayout& form, const ExportOffer& offer);

    /// Emits nothing.
    void show(const FilmChoices& choices);
    [[nodiscard]] FilmChoices choices() const;
    void setEnabled(bool enabled);

Q_SIGNALS:
    /// The user has changed it.
    void changed();

private:
    void addRecording(QFormLayout& form);
    void addPart(QFormLayout& form);
    void addLook(QFormLayout& form);
    void connectInputs();
    void browse(bool isBundle);
    [[nodiscard]] QComboBox* newMoments(const char* name, const QString& tip) const;
    void showMoment(QComboBox& list, const QString& key) const;
    [[nodiscard]] QString momentOf(const QComboBox& list) const;

    const ExportOffer& offer_;
    QLineEdit* recording_ = nullptr;
    QComboBox* from_ = nullptr;
    QComboBox* to_ = nullptr;
    QComboBox* view_ = nullptr;
    QDoubleSpinBox* speed_ = nullptr;
    QSpinBox* fps_ = nullptr;
    QWidget* recordingRow_ = nullptr;
    QWidget* partRow_ = nullptr;
    QWidget* rateRow_ = nullptr;
};

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
    /// Instead of a picture, what the file will hold.
    void showWords(const QString& words);
    /// The file that will be written; empty: the name is none.
    void showFile(const QString& path);
    /// Shows why nothing can be written, a sentence; empty: it can.
    void showFailure(const QString& reason);
    /// Room of the preview [pixel].
    [[nodiscard]] QSize previewRoom() const;

    [[nodiscard]] QSize sizeHint() const override;

Q_SIGNALS:
    /// The user has changed choices().
    void changed();
    void exportRequested();
    void copyRequested();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    [[nodiscard]] QWidget* newForm();
    void addPicture(QFormLayout& form);
    void addParts(QFormLayout& form);
    void addLocation(QFormLayout& form);
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
    QCheckBox* dent_ = nullptr;
    FilmFields* film_ = nullptr;
    QLineEdit* folder_ = nullptr;
    QLineEdit* name_ = nullptr;
    QLabel* file_ = nullptr;
    ExportPicture* picture_ = nullptr;
    QLabel* message_ = nullptr;
    QPushButton* copy_ = nullptr;
    QPushButton* export_ = nullptr;
};

/// A picture as large as it fits, on the checks that show through where it is transparent; or words
/// in its slot.
class ExportPicture : public QWidget {
    Q_OBJECT

public:
    explicit ExportPicture(QWidget* parent = nullptr);

    void setPicture(const QImage& picture);
    void setWords(const QString& words);
    [[nodiscard]] const QImage& picture() const { return picture_; }
    [[nodiscard]] const QString& words() const { return words_; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QImage picture_;
    QString words_;  ///< empty: there is a picture
};

}  // namespace asperity
