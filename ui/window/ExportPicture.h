#pragma once

#include <QImage>
#include <QString>
#include <QWidget>

namespace asperity {

/// A picture as large as it fits, on the checks that show through where it is transparent; or words
/// in its place.
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
