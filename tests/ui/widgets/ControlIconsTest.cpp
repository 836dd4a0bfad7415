#include "tests/support/PixelCount.h"
#include "ui/widgets/LabStyle.h"
#include "ui/widgets/Theme.h"

#include <QImage>

#include <gtest/gtest.h>

namespace asperity {
namespace {

TEST(ControlIcons, StartAndPauseCanBeSeenOnADisabledButtonToo) {
    for (const ControlIcon icon : {ControlIcon::Start, ControlIcon::Pause}) {
        const QIcon drawn = controlIcon(icon);
        const auto has = [&drawn](QIcon::Mode mode, const QColor& color) {
            return test::pixelsLike(drawn.pixmap(16, 16, mode).toImage(), color);
        };
        EXPECT_GT(has(QIcon::Normal, theme::colors().onAccent), 20);
        EXPECT_GT(has(QIcon::Disabled, theme::colors().muted), 20);
    }
}

}  // namespace
}  // namespace asperity
