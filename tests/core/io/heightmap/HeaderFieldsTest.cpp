#include "core/io/heightmap/HeaderFields.h"

#include "core/Error.h"
#include "tests/support/Refusal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace asperity::test {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;

}  // namespace

TEST(HeaderFields, EndsAfterItsMark) {
    const std::string text = "title\n[end]data";
    const MemoryBytes bytes(text, "a file");
    const HeaderText header = headerText(bytes, "[end]");
    EXPECT_EQ(header.text, "title\n");
    EXPECT_EQ(header.end, 11U);
}

TEST(HeaderFields, MarkIsNotSearchedInTheSamples) {
    const std::string text = std::string(1U << 18U, 'x') + "[end]";
    const MemoryBytes bytes(text, "a file");
    EXPECT_THAT(refusalOf([&] { (void)headerText(bytes, "[end]"); }),
                HasSubstr("a file: header: no '[end]' ends it"));
}

TEST(HeaderFields, LinesEndWithAnyLineEnd) {
    EXPECT_THAT(linesOf("a\r\n\nb"), ElementsAre("a", "", "b"));
    EXPECT_THAT(linesOf("a\rb\r"), ElementsAre("a", "b"));
    EXPECT_THAT(linesOf(""), ElementsAre());
}

TEST(HeaderFields, FieldsAreUtf8AndTheFirstOneCounts) {
    HeaderFields fields("a file", "[Scan]");
    fields.add(" Size ", " 50 \xB5m\r");
    fields.add("Size", "60 nm");
    EXPECT_EQ(fields.text("Size"), "50 \u00B5m");
    EXPECT_EQ(fields.text("Angle"), "");
    EXPECT_EQ(fields.find("Angle"), nullptr);
}

TEST(HeaderFields, NumbersAreCheckedAndNamed) {
    HeaderFields fields("a file", "[Scan]");
    fields.add("Lines", "256");
    fields.add("Rate", "1.5e-003");
    fields.add("Mode", "fast");
    EXPECT_EQ(fields.integer("Lines"), 256);
    EXPECT_DOUBLE_EQ(fields.number("Rate").value_or(0.0), 1.5e-3);
    EXPECT_EQ(fields.number("Angle"), std::nullopt);
    EXPECT_THAT(refusalOf([&] { (void)fields.number("Mode"); }),
                HasSubstr("a file: [Scan] Mode: expected a number, found 'fast'"));
    EXPECT_THAT(refusalOf([&] { (void)fields.integer("Rate"); }),
                HasSubstr("[Scan] Rate: expected a whole number"));
    EXPECT_THAT(refusalOf([&] { (void)fields.integer("Angle"); }),
                HasSubstr("a file: [Scan]: it has no 'Angle'"));
    EXPECT_DOUBLE_EQ(fields.requiredNumber("Rate"), 1.5e-3);
    EXPECT_THAT(refusalOf([&] { (void)fields.requiredNumber("Angle"); }),
                HasSubstr("it has no 'Angle'"));
}

TEST(HeaderFields, SectionsKeepTheirFields) {
    const HeaderSections sections =
        sectionsOf("lost=1\n[Scan]\nA=b=c\nno separator\n[Info]\r\n  D = e\r\n", '=', "a file");
    ASSERT_EQ(sections.size(), 2U);
    EXPECT_EQ(sections.at("Scan").text("A"), "b=c");
    EXPECT_EQ(sections.at("Info").text("D"), "e");
    EXPECT_EQ(sections.at("Scan").all().size(), 1U);
}

TEST(HeaderFields, LengthsHaveAUnit) {
    EXPECT_DOUBLE_EQ(parseLength("-712.919 nm").value_or(0.0), -712.919e-9);
    EXPECT_EQ(parseLength("5 V"), std::nullopt);
    EXPECT_EQ(parseLength("5"), std::nullopt);
    EXPECT_EQ(parseLength("wide"), std::nullopt);
}

}  // namespace asperity::test
