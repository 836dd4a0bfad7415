#pragma once

#include "ui/window/ExportChoices.h"

#include <QObject>

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace asperity {

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
    /// By the user.
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

}  // namespace asperity
