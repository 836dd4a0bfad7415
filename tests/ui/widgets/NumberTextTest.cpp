#include "ui/widgets/ShownText.h"

#include <gtest/gtest.h>

namespace asperity {
namespace {

const QLocale kGerman(QLocale::German, QLocale::Germany);
const QLocale kEnglish(QLocale::English, QLocale::UnitedStates);

TEST(NumberText, TakesTheFormOfFilesInAnyLanguage) {
    for (const QLocale& locale : {QLocale::c(), kEnglish, kGerman}) {
        EXPECT_EQ(numberFromText("0.5", locale), 0.5);
        EXPECT_EQ(numberFromText(" 2.5e-3 ", locale), 2.5e-3);
        EXPECT_EQ(numberFromText("-1.234", locale), -1.234) << "not a thousand";
    }
}

TEST(NumberText, TakesTheDecimalCommaWhereTheLanguageHasOne) {
    EXPECT_EQ(numberFromText("0,5", kGerman), 0.5);
    EXPECT_EQ(numberFromText("2,5e-3", kGerman), 2.5e-3);
    for (const QLocale& locale : {QLocale::c(), kEnglish}) {
        EXPECT_EQ(numberFromText("0,5", locale), std::nullopt) << "neither 5 nor 0.5";
        EXPECT_EQ(numberFromText("2,5", locale), std::nullopt);
    }
}

TEST(NumberText, RefusesTheRest) {
    for (const QLocale& locale : {QLocale::c(), kEnglish, kGerman}) {
        for (const char* text : {"", "oops", "1.000.000", "1,234,567", "1.234,5", "1,234.5", "inf",
                                 "nan", "1e999", "0.5 nm", "5 5"}) {
            EXPECT_EQ(numberFromText(text, locale), std::nullopt) << text;
        }
    }
}

TEST(NumberText, LengthsAreNoFinerThanAPicometer) {
    EXPECT_EQ(siText(12.34e-9, "m"), QStringLiteral("12.3 nm"));
    EXPECT_EQ(siText(-0.4942e-9, "m"), QStringLiteral("-494 pm"));
    EXPECT_EQ(siText(12.34e-12, "m"), QStringLiteral("12 pm"));
    EXPECT_EQ(siText(30e-15, "m"), QStringLiteral("0 pm"));
    EXPECT_EQ(siText(30e-15, "J"), QStringLiteral("30 fJ"));
}

}  // namespace
}  // namespace asperity
