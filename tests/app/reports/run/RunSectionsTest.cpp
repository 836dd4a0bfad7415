#include "app/reports/run/RunSections.h"

#include "core/scene/Scene.h"
#include "tests/support/TestScenes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <variant>
#include <vector>

namespace asperity {
namespace {

using testing::Contains;
using testing::Each;
using testing::HasSubstr;
using testing::Not;

std::vector<std::string> paragraphsOf(const PageContent& page) {
    std::vector<std::string> texts;
    for (const PageBlock& block : page.blocks()) {
        if (const auto* const paragraph = std::get_if<PageParagraph>(&block)) {
            texts.push_back(paragraph->text);
        }
        if (const auto* const list = std::get_if<PageList>(&block)) {
            texts.insert(texts.end(), list->items.begin(), list->items.end());
        }
    }
    return texts;
}

std::vector<PageTable> tablesOf(const PageContent& page) {
    std::vector<PageTable> tables;
    for (const PageBlock& block : page.blocks()) {
        if (const auto* const table = std::get_if<PageTable>(&block)) {
            tables.push_back(*table);
        }
    }
    return tables;
}

/// A run that touches, with these flags in contact.
RunHistory historyOf(const std::vector<Validity>& flags) {
    RunHistory history;
    TickSample sample;
    sample.output.model.contact.branch = ContactBranch::Far;
    history.take(sample);
    sample.output.model.contact = {
        .indentation = 1e-9, .contactRadius = 3e-9, .branch = ContactBranch::Bonded};
    sample.output.model.contactRatio = 1.0;
    for (const Validity flag : flags) {
        sample.output.flags.set(flag, true);
    }
    history.take(sample);
    return history;
}

PageContent validityOf(const std::vector<Validity>& flags) {
    PageContent page;
    addValidity(page, historyOf(flags));
    return page;
}

TEST(RunSections, ValidityDoesNotSendTheReaderToItself) {
    const std::vector<std::string> texts =
        paragraphsOf(validityOf({Validity::LargeContact, Validity::BeyondSphere}));
    EXPECT_THAT(texts, Contains(HasSubstr("does not hold in full in 1 of 2 ticks")));
    EXPECT_THAT(texts, Each(Not(HasSubstr("under Validity"))));
    EXPECT_THAT(texts, Contains(HasSubstr("ratio to the effective radius")));
    EXPECT_THAT(texts, Each(Not(HasSubstr("1 effective radii"))));
}

TEST(RunSections, ValidityBeginsWithWhatMayChangeTheForceMost) {
    const std::vector<PageTable> tables =
        tablesOf(validityOf({Validity::LargeContact, Validity::BeyondSphere}));
    ASSERT_EQ(tables.size(), 1U);
    ASSERT_EQ(tables[0].rows.size(), 2U);
    EXPECT_THAT(tables[0].rows[0][0].text, HasSubstr("beyond_sphere"));
}

TEST(RunSections, ParametersHaveNoEmptyRows) {
    PageContent page;
    addParameters(page, buildScene(test::plainScene(), test::flatMap()));
    for (const PageTable& table : tablesOf(page)) {
        for (const auto& row : table.rows) {
            EXPECT_NE(row[1].text, "") << row[0].text;
        }
    }
}

/// One force cycle whose pull-off force may hide so much, relative to its value.
PageContent uncertaintyOf(double hidden) {
    const CycleBudget pullOff{"pull_off_force_n",
                              "pull-off force",
                              "N",
                              {.value = 10e-9, .noise = 0.1e-9, .hidden = hidden * 10e-9}};
    PageContent page;
    addUncertainty(page, buildScene(test::plainScene(), test::flatMap()),
                   {{.cycle = {}, .budgets = {pullOff}}, {.cycle = {}, .budgets = {pullOff}}});
    return page;
}

TEST(RunSections, UncertaintySaysOnceWhatRoughnessTheNoiseHides) {
    const std::string remark = "Noise of the heights hides roughness that may move the pull-off "
                               "force by 9 %; the stated deviations do not include it.";
    EXPECT_THAT(paragraphsOf(uncertaintyOf(0.09)), Contains(remark).Times(1));
    EXPECT_THAT(paragraphsOf(uncertaintyOf(0.04)), Each(Not(HasSubstr("hides roughness"))))
        << "within the tolerance";
}

}  // namespace
}  // namespace asperity
