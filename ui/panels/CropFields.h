#pragma once

#include "core/surface/PixelRectangle.h"

#include <QSize>
#include <QSizeF>
#include <QWidget>

#include <optional>

class QGridLayout;
class QLabel;
class QPushButton;
class QSpinBox;

namespace asperity {

/// Numbers for the part of a scan that is loaded, in pixels, with its size. All of the scan is no
/// part: the fields show it whole then.
class CropFields : public QWidget {
    Q_OBJECT

public:
    explicit CropFields(QWidget* parent = nullptr);

    /// Shows a scan that comes meanwhile: a number that is being typed stays.
    /// @param pixels of the scan
    /// @param size   of the scan [m]; empty: not known
    void showScan(const QSize& pixels, const QSizeF& size,
                  const std::optional<PixelRectangle>& crop);
    /// What a user chose elsewhere: it counts, not what is being typed.
    void setCrop(const std::optional<PixelRectangle>& crop);
    [[nodiscard]] const std::optional<PixelRectangle>& crop() const { return crop_; }

Q_SIGNALS:
    /// By a number, or by the button that takes it back.
    void cropEntered(std::optional<asperity::PixelRectangle> crop);

private:
    [[nodiscard]] QSpinBox* addBox(QGridLayout& grid, const QPoint& place, const char* name,
                                   const QString& caption, const QString& tip);
    void enter();
    /// What becomes of a number that is being typed when others are shown.
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
