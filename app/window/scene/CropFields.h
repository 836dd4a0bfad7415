#pragma once

#include "core/surface/HeightMap.h"

#include <QImage>
#include <QPixmap>
#include <QPoint>
#include <QSize>
#include <QSizeF>
#include <QWidget>

#include <optional>

class QGridLayout;
class QLabel;
class QPushButton;
class QSpinBox;

namespace asperity {

/// A picture of a scan with its scale bar. Where that is wanted the mouse draws the part to load
/// on it; a click without a drag, or Esc while it is drawn, takes it back.
class CropPicture : public QWidget {
    Q_OBJECT

public:
    explicit CropPicture(QWidget* parent = nullptr);

    /// A null image: there is none, and `words` say why.
    /// @param pixels of the scan, more than the image may have
    /// @param size   of the scan [m]; empty: not known, no scale bar
    void setPicture(const QImage& image, const QSize& pixels, const QSizeF& size);
    void setWords(const QString& words);
    /// From now on the mouse draws.
    void setDrawable(bool drawable);
    /// The part that is shown; none: all of it.
    void setCrop(const std::optional<PixelRectangle>& crop);
    [[nodiscard]] const std::optional<PixelRectangle>& crop() const { return crop_; }

    /// Returns the rectangle in which the picture is drawn [px].
    [[nodiscard]] QRect pictureRect() const;

    [[nodiscard]] QSize sizeHint() const override { return {320, 260}; }

Q_SIGNALS:
    /// While the mouse draws.
    void cropDragged(std::optional<asperity::PixelRectangle> crop);
    /// It is drawn, or taken back.
    void cropDrawn(std::optional<asperity::PixelRectangle> crop);

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    /// The pixels between two positions on the screen; none where they are too near to be meant.
    [[nodiscard]] std::optional<PixelRectangle> between(const QPoint& from, const QPoint& to) const;
    [[nodiscard]] QRectF onScreen(const PixelRectangle& part) const;
    void drawCrop(QPainter& painter, const QRect& picture) const;

    QImage image_;
    QPixmap scaled_;  ///< of the image, as large as it is drawn; null: not made yet
    QSize pixels_;
    QSizeF size_;
    QString words_;
    bool drawable_ = false;
    std::optional<PixelRectangle> crop_;
    std::optional<PixelRectangle> before_;  ///< the crop before the mouse began to draw
    std::optional<QPoint> from_;            ///< where the mouse began to draw
};

/// Numbers for the part of a scan that is loaded, in pixels, with its size. All of the scan is no
/// part: the fields show it whole then.
class CropFields : public QWidget {
    Q_OBJECT

public:
    explicit CropFields(QWidget* parent = nullptr);

    /// Shows another scan; a number that is being typed stays.
    /// @param pixels of the scan
    /// @param size   of the scan [m]; empty: not known
    void showScan(const QSize& pixels, const QSizeF& size,
                  const std::optional<PixelRectangle>& crop);
    /// Sets the part that a user chose elsewhere: it replaces a number that is being typed.
    void setCrop(const std::optional<PixelRectangle>& crop);
    [[nodiscard]] const std::optional<PixelRectangle>& crop() const { return crop_; }

Q_SIGNALS:
    /// The part was entered as numbers, or reset by the button.
    void cropEntered(std::optional<asperity::PixelRectangle> crop);

private:
    [[nodiscard]] QSpinBox* addBox(QGridLayout& grid, const QPoint& cell, const char* name,
                                   const QString& caption, const QString& tip);
    void enter();
    /// Treatment of a number that is being typed when others are shown.
    enum class Typed { Stays, Goes };
    void showNumbers(Typed typed);

    QSize pixels_{1, 1};
    QSizeF size_;
    std::optional<PixelRectangle> crop_;
    QSpinBox* column_;
    QSpinBox* row_;
    QSpinBox* columns_;
    QSpinBox* rows_;
    QLabel* extent_;
    QPushButton* whole_;
};

}  // namespace asperity
