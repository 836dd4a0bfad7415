#include "app/runs/RunFolder.h"
#include "core/Error.h"
#include "tests/support/ScratchFolder.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace asperity {
namespace {

TEST(RecordedSummary, HasProgramNotesAndTerms) {
    const test::ScratchFolder scratch;
    (void)scratch.write("summary.json", R"({"versions": {"asperity": "0.1.0", "compiler": "12"},
        "input": {"notes": ["one", "two"]}, "model": {"terms": [
        {"term": "friction", "on": true, "overruled": true, "why": "because", "effect": 0.5}]}})");
    const auto [program, summary] = readRecord(scratch.path());
    ASSERT_TRUE(summary);
    EXPECT_EQ(summary->notes, (std::vector<std::string>{"one", "two"}));
    ASSERT_EQ(summary->terms.size(), 1U);
    EXPECT_EQ(summary->terms[0].name, "friction");
    EXPECT_TRUE(summary->terms[0].on && summary->terms[0].overruled);
    EXPECT_EQ(summary->terms[0].effect, 0.5);
    EXPECT_EQ(program->compiler, "12");
}

TEST(RecordedSummary, OfAnEarlierVersionLacksWhatThatDidNotWrite) {
    const test::ScratchFolder scratch;
    (void)scratch.write("summary.json", R"({"input": {}})");
    const auto [program, summary] = readRecord(scratch.path());
    ASSERT_TRUE(summary);
    EXPECT_TRUE(summary->notes.empty() && summary->terms.empty());
    EXPECT_FALSE(program);
}

TEST(RecordedSummary, IsNoneOfARunThatWasCutOff) {
    const test::ScratchFolder scratch;
    (void)scratch.write("recording.json", R"({"versions": {"asperity": "0.1.0"}})");
    const auto [program, summary] = readRecord(scratch.path());
    EXPECT_FALSE(summary);
    EXPECT_EQ(program->version, "0.1.0");
}

TEST(RecordedSummary, ThatIsDamagedIsRefused) {
    for (const char* text : {"{", "[1]", R"({"model": {"terms": [7]}})", R"({"input": 3})"}) {
        const test::ScratchFolder scratch;
        (void)scratch.write("summary.json", text);
        EXPECT_THROW((void)readRecord(scratch.path()), InputError) << text;
    }
}

}  // namespace
}  // namespace asperity
