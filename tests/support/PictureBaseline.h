#pragma once

#include <QImage>
#include <QString>

#include <string>

namespace asperity::test {

/// How far two reduced pictures are apart, in gray levels (0 to 255) as a mean over pixels and
/// colors.
struct PictureDifference {
    double all = 0.0;    ///< of the whole pictures
    double worst = 0.0;  ///< of the block of 8 x 5 reduced pixels where they differ most
    QRect place;         ///< of that block, in reduced pixels
};

/// 160 x 100 pixels, each the mean of what it stands for: letters become gray, so that hinting and
/// smoothing make no difference, but a panel that is missing or has other colors does.
[[nodiscard]] QImage reduced(const QImage& picture);

/// Of two reduced pictures.
[[nodiscard]] PictureDifference difference(const QImage& one, const QImage& other);

/// Compares a picture with the reduced one of this name in tests/reference/pictures. With
/// ASPERITY_RENEW_PICTURES=1 in the environment it writes that one anew.
/// @return empty where they agree, else what is wrong and where both are to be seen
[[nodiscard]] std::string compareWithBaseline(const QImage& picture, const QString& name,
                                              double tolerance);

}  // namespace asperity::test
