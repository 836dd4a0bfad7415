#include "app/reports/run/RunSections.h"

#include <gtest/gtest.h>

#include <string>

namespace asperity {
namespace {

/// With spaces in place of those that do not break a line.
std::string plain(std::string text) {
    for (std::size_t at = text.find("\u00A0"); at != std::string::npos; at = text.find("\u00A0")) {
        text.replace(at, 2, " ");
    }
    return text;
}

TEST(MeasuredText, HasTwoDigitsOfTheDeviation) {
    const SiScale nano{1e9, "nN"};
    EXPECT_EQ(plain(measuredText({3.39463e-9, 8.64e-11}, nano)), "3.395 ± 0.086");
    EXPECT_EQ(plain(measuredText({16.9158e-9, 2.345e-10}, nano)), "16.92 ± 0.23");
    EXPECT_EQ(plain(measuredText({1234.4e-9, 120e-9}, nano)), "1234 ± 120");
    EXPECT_EQ(plain(measuredText({-3.49e-9, 2.1e-10}, "N")), "(-3.49 ± 0.21) nN");
}

TEST(MeasuredText, WithoutADeviationHasFourDigits) {
    const SiScale nano{1e9, "nm"};
    EXPECT_EQ(measuredText({1.4e-9, 0.0}, nano), "1.400");
    EXPECT_EQ(numberText(515e-9, nano), "515.0");
    EXPECT_EQ(numberText(1234.4e-9, nano), "1234");
    EXPECT_EQ(numberText(-0.0, nano), "0");
    EXPECT_EQ(measuredText({2e-9, 0.0}, "N"), "2.000 nN");
}

TEST(MeasuredText, HasEnergiesOfAContactInAttojoules) {
    EXPECT_EQ(plain(measuredText({1.92e-18, 1.24e-20}, "J")), "(1.920 ± 0.012) aJ");
}

TEST(ShareText, ShowsWhatIsNotZero) {
    EXPECT_EQ(plain(shareText(0, 100)), "0 %");
    EXPECT_EQ(plain(shareText(1, 100000)), "< 0.1 %");
    EXPECT_EQ(plain(shareText(190, 1000)), "19.0 %");
    EXPECT_EQ(plain(shareText(0, 0)), "0 %");
}

}  // namespace
}  // namespace asperity
