#include "tests/support/PictureBaseline.h"

#include "tests/support/Places.h"

#include <QDir>
#include <QFileInfo>

#include <cstdlib>

namespace asperity::test {

namespace {

constexpr QSize kReduced(160, 100);
constexpr QSize kBlock(8, 5);

double differenceIn(const QImage& one, const QImage& other, const QRect& place) {
    double sum = 0.0;
    for (int y = place.top(); y <= place.bottom(); ++y) {
        for (int x = place.left(); x <= place.right(); ++x) {
            const QRgb a = one.pixel(x, y);
            const QRgb b = other.pixel(x, y);
            sum += std::abs(qRed(a) - qRed(b)) + std::abs(qGreen(a) - qGreen(b)) +
                   std::abs(qBlue(a) - qBlue(b));
        }
    }
    return sum / (3.0 * place.width() * place.height());
}

QString baselineFile(const QString& name) {
    const auto folder = QString::fromStdString((referenceFolder() / "pictures").string());
    return QStringLiteral("%1/%2.png").arg(folder, name);
}

/// Where the picture that differs is left to be looked at.
QString leave(const QImage& picture, const QString& name) {
    const QString file = QDir::temp().filePath(QStringLiteral("asperity_%1.png").arg(name));
    picture.save(file);
    return file;
}

}  // namespace

QImage reduced(const QImage& picture) {
    return picture.convertToFormat(QImage::Format_RGB32)
        .scaled(kReduced, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

PictureDifference difference(const QImage& one, const QImage& other) {
    PictureDifference found{.all = differenceIn(one, other, one.rect()), .worst = 0.0, .place = {}};
    for (int y = 0; y < kReduced.height(); y += kBlock.height()) {
        for (int x = 0; x < kReduced.width(); x += kBlock.width()) {
            const QRect block(QPoint(x, y), kBlock);
            const double here = differenceIn(one, other, block);
            if (here > found.worst) {
                found.worst = here;
                found.place = block;
            }
        }
    }
    return found;
}

std::string compareWithBaseline(const QImage& picture, const QString& name, double tolerance) {
    const QString file = baselineFile(name);
    const QImage small = reduced(picture);
    const char* renews = std::getenv("ASPERITY_RENEW_PICTURES");  // NOLINT(concurrency-mt-unsafe)
    if (renews != nullptr && std::string(renews) == "1") {
        QDir().mkpath(QFileInfo(file).path());
        return small.save(file) ? "" : "cannot write " + file.toStdString();
    }
    const QImage baseline(file);
    if (baseline.isNull()) {
        return "there is no " + file.toStdString();
    }
    const PictureDifference apart =
        difference(small, baseline.convertToFormat(QImage::Format_RGB32));
    if (apart.worst <= tolerance) {
        return "";
    }
    const QPoint place = apart.place.center();
    return QStringLiteral(
               "%1 differs by %2 gray levels around (%3 %, %4 %) of the picture, by %5 in "
               "all; it is %6, and should be like %7")
        .arg(name)
        .arg(apart.worst, 0, 'f', 1)
        .arg(100 * place.x() / kReduced.width())
        .arg(100 * place.y() / kReduced.height())
        .arg(apart.all, 0, 'f', 1)
        .arg(leave(picture, name), file)
        .toStdString();
}

}  // namespace asperity::test
