#include "ui/widgets/Theme.h"

#include <QApplication>
#include <QLabel>
#include <QPalette>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <ostream>
#include <vector>

namespace asperity {

void PrintTo(const Color& color, std::ostream* stream) {
    *stream << int(color.red) << ", " << int(color.green) << ", " << int(color.blue);
}

namespace {

double linear(std::uint8_t part) {
    const double share = part / 255.0;
    return share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
}

double luminance(const Color& color) {
    return 0.2126 * linear(color.red) + 0.7152 * linear(color.green) + 0.0722 * linear(color.blue);
}

/// Of WCAG 2.1: 1 ... 21.
double contrast(const Color& a, const Color& b) {
    const auto [dark, light] = std::minmax({luminance(a), luminance(b)});
    return (light + 0.05) / (dark + 0.05);
}

Color mixed(const Color& from, const Color& to, double part) {
    const auto mix = [part](std::uint8_t a, std::uint8_t b) {
        return static_cast<std::uint8_t>(std::lround(std::lerp(double(a), double(b), part)));
    };
    return {mix(from.red, to.red), mix(from.green, to.green), mix(from.blue, to.blue)};
}

/// CIE L*a*b* of a color under D65.
std::array<double, 3> lab(const Color& color) {
    const double r = linear(color.red);
    const double g = linear(color.green);
    const double b = linear(color.blue);
    const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116.0; };
    const double x = f((0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.95047);
    const double y = f(0.2126 * r + 0.7152 * g + 0.0722 * b);
    const double z = f((0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.08883);
    return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

double difference(const Color& a, const Color& b) {
    const auto one = lab(a);
    const auto other = lab(b);
    return std::hypot(one[0] - other[0], one[1] - other[1], one[2] - other[2]);
}

class Themes : public ::testing::TestWithParam<const Palette*> {};

/// All pairs of letters and what is behind them that the window has.
TEST_P(Themes, LettersHaveAContrastOf45ToWhatIsBehindThem) {
    const Palette& colors = *GetParam();
    struct Pair {
        const char* name;
        Color text;
        std::vector<Color> behind;
    };
    std::vector<Color> banners;
    for (const Color& state :
         {colors.fault, colors.muted, colors.caution, colors.tip, colors.orange, colors.green}) {
        banners.push_back(mixed(colors.window, state, 0.12));
    }
    const std::vector<Pair> pairs{
        {"ink", colors.ink, {colors.paper, colors.window, colors.backdrop, colors.wash}},
        {"ink on a banner", colors.ink, banners},
        {"muted", colors.muted, {colors.paper, colors.window}},
        {"accent", colors.accent, {colors.paper, colors.wash}},
        {"on accent", colors.onAccent, {colors.accent}},
        {"fault", colors.fault, {colors.paper, colors.window, colors.refused}},
        {"caution", colors.caution, {colors.paper, colors.window}},
        {"caution on a banner", colors.caution, banners},
        {"force", colors.force, {colors.paper}}};
    for (const Pair& pair : pairs) {
        for (const Color& behind : pair.behind) {
            EXPECT_GE(contrast(pair.text, behind), 4.5)
                << pair.name << " on " << ::testing::PrintToString(behind);
        }
    }
}

TEST_P(Themes, CurvesAreToldApartAndFromThePaper) {
    const Palette& colors = *GetParam();
    for (std::size_t i = 0; i < 7; ++i) {
        const Color& one = seriesColor(colors, i);
        EXPECT_GE(difference(one, colors.paper), 40.0) << i;
        for (std::size_t k = 0; k < i; ++k) {
            EXPECT_GE(difference(one, seriesColor(colors, k)), 24.0) << k << ", " << i;
        }
    }
    EXPECT_GE(difference(colors.force, colors.backdrop), 40.0);
    EXPECT_GE(difference(colors.guide, colors.backdrop), 40.0);
    EXPECT_GE(difference(colors.target, colors.backdrop), 40.0);
    EXPECT_GE(difference(colors.side, colors.backdrop), 15.0) << "the block stands out";
}

INSTANTIATE_TEST_SUITE_P(, Themes, ::testing::Values(&kLightPalette, &kDarkPalette),
                         [](const auto& theme) {
                             return theme.param == &kDarkPalette ? "Dark" : "Light";
                         });

TEST(Theme, CurvesOnDarkPaperStandOutAsLettersDo) {
    for (std::size_t i = 0; i < 7; ++i) {
        EXPECT_GE(contrast(seriesColor(kDarkPalette, i), kDarkPalette.paper), 4.5) << i;
    }
}

/// Leaves the theme as it was.
class ThemeSwitch : public ::testing::Test {
protected:
    void TearDown() override { theme::choose(ThemeChoice::Desktop); }
};

TEST_F(ThemeSwitch, ChangesTheColorsOfAllWhileTheProgramRuns) {
    theme::choose(ThemeChoice::Light);
    EXPECT_FALSE(theme::isDark());
    EXPECT_EQ(theme::colors().paper, QColor(255, 255, 255));
    QLabel label;
    theme::colorText(label, &ThemeColors::caution);
    theme::choose(ThemeChoice::Dark);
    EXPECT_TRUE(theme::isDark());
    EXPECT_EQ(theme::choice(), ThemeChoice::Dark);
    EXPECT_EQ(theme::colors().paper, toQColor(kDarkPalette.paper));
    EXPECT_EQ(&theme::palette(), &kDarkPalette);
    EXPECT_EQ(QApplication::palette().color(QPalette::Text), toQColor(kDarkPalette.ink));
    EXPECT_EQ(label.palette().color(QPalette::WindowText), toQColor(kDarkPalette.caution));
    theme::choose(ThemeChoice::Light);
    EXPECT_EQ(label.palette().color(QPalette::WindowText), toQColor(kLightPalette.caution));
}

TEST_F(ThemeSwitch, WhoeverFollowsIsAskedAtOnceAndAtEachChangeUntilItsEnd) {
    theme::choose(ThemeChoice::Light);
    int asked = 0;
    auto owner = std::make_unique<QObject>();
    theme::follow(owner.get(), [&asked] { ++asked; });
    EXPECT_EQ(asked, 1);
    theme::choose(ThemeChoice::Light);
    EXPECT_EQ(asked, 1) << "nothing changed";
    theme::choose(ThemeChoice::Dark);
    EXPECT_EQ(asked, 2);
    owner.reset();
    theme::choose(ThemeChoice::Light);
    EXPECT_EQ(asked, 2);
}

TEST(Theme, EveryColorOfBothPalettesReachesQt) {
    const ThemeColors& colors = theme::colors();
    // A struct of QColor and nothing else.
    const auto* all = reinterpret_cast<const QColor*>(&colors);
    for (std::size_t i = 0; i < sizeof(ThemeColors) / sizeof(QColor); ++i) {
        EXPECT_TRUE(all[i].isValid()) << i;
    }
}

TEST(Theme, LettersAreMeasuredInPointsAndLengthsGrowWithThem) {
    EXPECT_NEAR(theme::textFont().pointSizeF(), 9.0, 0.6);
    EXPECT_NEAR(theme::textFont(theme::kSmallSize).pointSizeF() / theme::textFont().pointSizeF(),
                8.0 / 9.0, 0.01);
    EXPECT_GE(theme::scaled(100), 100);
}

}  // namespace
}  // namespace asperity
