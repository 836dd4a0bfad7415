#include "app/window/device/HapticControl.h"
#include "app/window/fidelity/FidelityPanel.h"
#include "app/window/live/ControlBar.h"
#include "app/window/live/StateBanner.h"
#include "app/window/scene/ScenePanel.h"
#include "core/scene/SettingFields.h"
#include "core/words/ModelWords.h"
#include "tests/ui/widgets/PanelSamples.h"
#include "ui/widgets/NumberBox.h"
#include "ui/widgets/ShownText.h"

#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QStandardItemModel>
#include <QTranslator>

#include <gtest/gtest.h>

#include <iostream>
#include <set>

namespace asperity::test {
namespace {

/// Translates the texts of core into themselves with marks around.
class MarkingTranslator : public QTranslator {
public:
    [[nodiscard]] bool isEmpty() const override { return false; }
    [[nodiscard]] QString translate(const char* context, const char* text, const char* /*note*/,
                                    int /*count*/) const override {
        return QLatin1String(context) == QLatin1String("asperity::core") ? marked(text) : QString();
    }
    static QString marked(const char* text) {
        return QStringLiteral("«%1»").arg(QString::fromUtf8(text));
    }
};

class CoreWords : public ::testing::Test {
protected:
    void SetUp() override { ASSERT_TRUE(QApplication::installTranslator(&translator)); }
    void TearDown() override { QApplication::removeTranslator(&translator); }
    static QString marked(const char* text) { return MarkingTranslator::marked(text); }
    static bool hasLabel(const QWidget& widget, const QString& text) {
        const auto labels = widget.findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(),
                           [&](const QLabel* label) { return label->text() == text; });
    }

    MarkingTranslator translator;
};

/// What the window shows from tables in core.
std::set<std::string> tableTexts() {
    std::set<std::string> texts;
    const auto add = [&texts](const char* text) {
        if (*text != '\0') {
            texts.insert(text);
        }
    };
    const auto addNames = [&add](const auto& table) {
        for (const auto& row : table) {
            add(row.name);
        }
    };
    addNames(kEnumTable<Fault>);
    addNames(kEnumTable<ForceState>);
    addNames(kEnumTable<TipRegion>);
    addNames(kEnumTable<ModelTerm>);
    for (const ModelTerm term : kModelTerms) {
        add(whyImpossible(term));
    }
    for (const ValidityTraits& flag : kValidityTraits) {
        add(flag.brief);
        add(flag.words);
    }
    for (const SceneField& field : sceneFields()) {
        add(field.words.caption);
        add(field.words.toolTip);
        for (const SceneChoice& choice : field.choices) {
            add(choice.name.c_str());
        }
    }
    for (const auto& group : kEnumTable<SceneGroup>) {
        add(group.name);
    }
    for (const auto& group : kEnumTable<SettingGroup>) {
        add(group.name);
    }
    const Settings any;
    listSettings(any, [&add](const SettingField& field, const auto& /*value*/) {
        add(field.words.caption);
        add(field.words.toolTip);
    });
    return texts;
}

TEST_F(CoreWords, ListsThemForATranslationFile) {
    std::cout << "<context>\n    <name>asperity::core</name>\n";
    for (const std::string& text : tableTexts()) {
        EXPECT_EQ(coreWords(text), marked(text.c_str()));
        std::cout << "    <message><source>"
                  << QString::fromStdString(text).toHtmlEscaped().toStdString()
                  << "</source><translation type=\"unfinished\"></translation></message>\n";
    }
    std::cout << "</context>\n";
}

TEST_F(CoreWords, TheBannerShowsStatesFaultsAndFlagsTranslated) {
    StateBanner banner;
    banner.resize(1600, banner.height());
    banner.grab();  // lays it out
    TickSample sample;
    sample.output.forceState = ForceState::Off;
    sample.output.flags.set(Validity::OutsideScan, true);
    banner.show(snapshotOf(sample));
    EXPECT_EQ(textOf(banner, "state"), marked("forces off") + QStringLiteral(" · ") +
                                           marked(asperity::nameOf(TipRegion::Far)));
    const ValidityTraits& flag = kValidityTraits.at(1);
    EXPECT_EQ(textOf(banner, "flags"), marked(flag.brief));
    EXPECT_TRUE(banner.toolTip().contains(marked(flag.words)));
    sample.output.fault = Fault::DeviceLost;
    banner.show(snapshotOf(sample));
    EXPECT_TRUE(textOf(banner, "state").contains(marked(asperity::nameOf(Fault::DeviceLost))));
}

TEST_F(CoreWords, TheTableOfTermsIsTranslated) {
    TermTable table;
    RequiredTerms needs;
    for (const ModelTerm term : kModelTerms) {
        needs.terms.push_back({.term = term, .possible = term != ModelTerm::FilmBase});
    }
    table.show(needs, {});
    for (int row = 0; row < table.rowCount(); ++row) {
        const ModelTerm term = kModelTerms.at(static_cast<std::size_t>(row));
        EXPECT_EQ(table.item(row, 0)->text(), marked(asperity::nameOf(term)));
    }
    const auto* film =
        table.findChild<QComboBox*>(QString::fromUtf8(asperity::nameOf(ModelTerm::FilmBase)));
    EXPECT_EQ(film->itemData(1, Qt::ToolTipRole).toString(),
              marked(whyImpossible(ModelTerm::FilmBase)));
}

TEST_F(CoreWords, KnobsAreTranslated) {
    const ControlBar bar;
    EXPECT_TRUE(hasLabel(bar, marked("Force gain")));
    const auto* gain = bar.findChild<GainSpinBox*>("forceGain");
    EXPECT_EQ(gain->toolTip(), marked("Force on the device per force on the tip"));
    const HapticPanel panel;
    EXPECT_TRUE(hasLabel(panel, marked("Force gain")));
    EXPECT_EQ(panel.findChild<QWidget*>("haptics.force_gain")->toolTip(),
              marked("Force on the device per force on the tip"));
}

TEST_F(CoreWords, KeysOfScenesAreTranslated) {
    const ScenePanel panel;
    for (const SceneField& field : sceneFields()) {
        if (field.input == SceneInput::Positions) {
            continue;  // entered with the steps of leveling
        }
        const auto* control =
            panel.findChild<QWidget*>(QString::fromStdString(asperity::nameOf(field)));
        ASSERT_NE(control, nullptr) << asperity::nameOf(field);
        EXPECT_EQ(control->toolTip(), marked(field.words.toolTip));
    }
    EXPECT_TRUE(hasLabel(panel, marked("Poisson's ratio")));
}

}  // namespace
}  // namespace asperity::test
