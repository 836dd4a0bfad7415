#include "core/io/TextValue.h"
#include "core/io/heightmap/PhysicalUnit.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity::test {

namespace {

void expectUnit(const char* text, double factor, const char* base) {
    const PhysicalUnit unit = parseUnit(toUtf8(text));
    EXPECT_DOUBLE_EQ(unit.factor, factor) << text;
    EXPECT_EQ(unit.base, base) << text;
}

}  // namespace

TEST(PhysicalUnit, TakesEveryWayToWriteMicro) {
    for (const char* text : {"um", "~m", "µm", "\u03BCm", "\xB5m"}) {
        expectUnit(text, 1e-6, "m");
    }
}

TEST(PhysicalUnit, TakesEveryWayToWriteAngstrom) {
    for (const char* text : {"\u00C5", "\u212B", "A\u030A", "\xC5", "Ang", "Angstrom"}) {
        expectUnit(text, 1e-10, "m");
    }
}

TEST(PhysicalUnit, TakesEveryWayToWriteDegrees) {
    for (const char* text : {"deg", "\u00B0", "\u00BA", "\xBA", "\xB0"}) {
        expectUnit(text, 1.0, "deg");
    }
}

TEST(PhysicalUnit, ReadsPrefixesAndQuotients) {
    expectUnit("nm", 1e-9, "m");
    expectUnit("m", 1.0, "m");
    expectUnit("mm", 1e-3, "m");
    expectUnit("mV", 1e-3, "V");
    expectUnit("A", 1.0, "A");
    expectUnit("pA", 1e-12, "A");
    expectUnit("kHz", 1e3, "Hz");
    expectUnit("Pa", 1.0, "Pa");
    expectUnit("GPa", 1e9, "Pa");
    expectUnit("nm/V", 1e-9, "m/V");
    expectUnit("nm/mV", 1e-6, "m/V");
    expectUnit("nA/V", 1e-9, "A/V");
}

TEST(PhysicalUnit, TakesNamesInFull) {
    expectUnit("Volt", 1.0, "V");
    expectUnit("volts", 1.0, "V");
    expectUnit("Meter", 1.0, "m");
    expectUnit("Nanometers", 1e-9, "m");
    expectUnit("micrometre", 1e-6, "m");
    expectUnit("microns", 1e-6, "m");
    expectUnit("picoampere", 1e-12, "A");
    expectUnit("hertz", 1.0, "Hz");
    expectUnit("nanometers/Volt", 1e-9, "m/V");
    expectUnit("s", 1.0, "s");
    expectUnit("nano", 1.0, "nano");
    expectUnit("Degrees", 1.0, "deg");
    expectUnit("Angstroms", 1e-10, "m");
    expectUnit("dimensionless", 1.0, "");
}

TEST(PhysicalUnit, OfALengthAIsTheAngstrom) {
    EXPECT_DOUBLE_EQ(parseLengthUnit(" A ").factor, 1e-10);
    EXPECT_EQ(parseLengthUnit("A").base, "m");
    EXPECT_EQ(parseLengthUnit("nA").base, "A");
    EXPECT_DOUBLE_EQ(parseLengthUnit("nm").factor, 1e-9);
}

TEST(PhysicalUnit, KeepsWhatItDoesNotKnow) {
    expectUnit("", 1.0, "");
    expectUnit("Arb", 1.0, "Arb");
    expectUnit("m^2", 1.0, "m^2");
    expectUnit("log(Pa)/log(Arb)", 1.0, "log(Pa)/log(Arb)");
}

TEST(TextValue, NumbersNeedTheWholeTextAndADecimalPoint) {
    EXPECT_EQ(parseNumber(" 1.5e-008 "), 1.5e-8);
    EXPECT_EQ(parseNumber("+3"), 3.0);
    EXPECT_TRUE(std::isnan(parseNumber("NaN").value()));
    EXPECT_TRUE(std::isinf(parseNumber("-inf").value()));
    for (const char* text : {"", " ", "1,5", "1.5 nm", "+-3", "++3", "1e999", "0x10"}) {
        EXPECT_FALSE(parseNumber(text)) << text;
    }
}

TEST(TextValue, IntegersDoNotOverflow) {
    EXPECT_EQ(parseInteger("-42"), -42);
    EXPECT_FALSE(parseInteger("99999999999999999999"));
    EXPECT_FALSE(parseInteger("3.0"));
}

TEST(TextValue, LatinTextBecomesUtf8AndUtf8Stays) {
    EXPECT_EQ(toUtf8("10 \xB5m"), "10 µm");
    EXPECT_EQ(toUtf8("10 µm"), "10 µm");
    EXPECT_EQ(toUtf8("\x80"), "€");
    EXPECT_EQ(toUtf8("cut \xC2"), "cut Â");
}

TEST(TextValue, ExactTextReadsBackToTheSameBits) {
    for (const double value : {0.1, 1.0 / 3.0, 8.484350000000001e-05, 5e-324, -0.0}) {
        EXPECT_EQ(parseNumber(exactText(value)), value);
    }
}

}  // namespace asperity::test
