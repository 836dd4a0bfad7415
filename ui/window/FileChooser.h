#pragma once

#include <QFileDialog>

class QLineEdit;

namespace asperity {

/// Folders and files as a part of a dialog: Qt's own file dialog without its buttons.
class FileChooser : public QFileDialog {
    Q_OBJECT

public:
    /// @param filters of file types, "Gwyddion .gwy (*.gwy)"
    explicit FileChooser(const QStringList& filters, QWidget* parent = nullptr);

    /// The file that is chosen or typed; empty: none that is there.
    [[nodiscard]] QString file() const;
    /// Folders that are one click away.
    void setPlaces(const QStringList& folders);
    /// Goes to its folder and chooses it.
    void choose(const QString& file);

    void accept() override;
    void reject() override { Q_EMIT canceled(); }
    void done(int /*result*/) override {}  // it stays where it is
    bool eventFilter(QObject* watched, QEvent* event) override;

Q_SIGNALS:
    /// file() is another one.
    void chosen(const QString& file);
    /// By Return or a double click.
    void activated();
    void canceled();

private:
    void watchName();

    QLineEdit* name_ = nullptr;
    QString file_;
};

}  // namespace asperity
