#include "app/window/curve/CurveFitControl.h"

#include "app/curves/CurveFit.h"
#include "app/window/curve/CurveColumnsDialog.h"
#include "app/window/curve/CurveFitForm.h"
#include "app/window/curve/CurveFitPage.h"
#include "tests/app/window/ControlFixture.h"
#include "tests/support/ReferenceTable.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTableWidget>

#include <cmath>
#include <fstream>

namespace asperity::test {
namespace {

/// A paraboloid of 5 um on 100 kPa, lever 0.1 N/m.
std::string elasticTable(const std::string& titles) {
    std::string text = titles;
    const double factor = 4.0 / 3.0 * 100e3 / 0.75 * std::sqrt(5e-6);
    for (int i = -300; i <= 300; ++i) {
        const double depth = i > 0 ? 2e-9 * i : 0.0;
        const double force = factor * std::pow(depth, 1.5);
        const double base = 2e-9 * i + force / 0.1;
        const double noise = 2e-12 * ((i * 7919) % 13 - 6);
        text += std::to_string(1e6 * base) + "\t" + std::to_string(1e9 * (force + noise)) + "\n";
    }
    return text;
}

class CurveFitControlTest : public ControlFixture {
protected:
    CurveFitControlTest() { useFlatScene(); }

    template <class Widget>
    Widget& part(const char* name) {
        return *page.findChild<Widget*>(QString::fromLatin1(name));
    }
    [[nodiscard]] bool opens(const std::filesystem::path& file, const CurveReadOptions& read = {}) {
        QSignalSpy shown(&control, &CurveFitControl::shown);
        control.open(file, read);
        return eventually([&] { return shown.count() == 1; });
    }
    void nameTip() {
        part<QComboBox>("fitTip").setCurrentIndex(2);
        part<QDoubleSpinBox>("fitStiffness").setValue(0.1);
    }
    QString value(const QString& name) {
        const auto& table = part<QTableWidget>("curveValues");
        for (int row = 0; row < table.rowCount(); ++row) {
            if (table.item(row, 0)->text() == name) {
                return table.item(row, 1)->text();
            }
        }
        return {};
    }

    /// As the table shows it [kPa].
    double modulus() {
        return value(QStringLiteral("Young's modulus")).section(QLatin1Char(' '), 0, 0).toDouble();
    }

    CurveFitControl& control = stage.add<CurveFitControl>();
    CurveFitPage& page{*window.findChild<CurveFitPage*>()};
};

TEST_F(CurveFitControlTest, FindsASampleAndSavesWhatTheCommandDoes) {
    nameTip();
    const auto file = folder.write("a.txt", elasticTable("base [um]\tforce [nN]\n"));
    ASSERT_TRUE(opens(file));
    EXPECT_NEAR(modulus(), 100.0, 0.5) << part<QLabel>("curveReasons").text().toStdString();
    EXPECT_TRUE(part<QLabel>("curveVerdict").text().contains(QStringLiteral("matched")));
    EXPECT_FALSE(page.plot().measured().approach.isEmpty()) << "the simulation";
    ASSERT_TRUE(part<QPushButton>("saveFit").isEnabled());
    QSignalSpy saved(&control, &CurveFitControl::saved);
    const auto out = folder.path() / "fit";
    control.save(out, false);
    ASSERT_TRUE(eventually([&] { return saved.count() == 1; })) << complaint();
    for (const char* name : {"fit.json", "curve.csv", "simulated.csv", "fit.png", "scene.toml"}) {
        EXPECT_TRUE(std::filesystem::exists(out / name)) << name;
    }
    std::ifstream json(out / "fit.json");
    const auto found = nlohmann::json::parse(json);
    const FittedCurve again = fittedCurve(file.string(), 0, {}, page.form().options());
    EXPECT_EQ(found["parameters"]["youngs_modulus_pa"]["value"].get<double>(),
              again.found.find("youngs_modulus_pa")->value);
    EXPECT_EQ(found["sha256"].get<std::string>(), again.sha256);
}

TEST_F(CurveFitControlTest, AChangedOptionFitsAgain) {
    nameTip();
    ASSERT_TRUE(opens(folder.write("a.txt", elasticTable("base [um]\tforce [nN]\n"))));
    QSignalSpy shown(&control, &CurveFitControl::shown);
    part<QComboBox>("fitTip").setCurrentIndex(0);
    EXPECT_FALSE(part<QPushButton>("saveFit").isEnabled()) << "the old fit is not saved as the new";
    ASSERT_TRUE(eventually([&] { return shown.count() == 1; }));
    EXPECT_TRUE(value(QStringLiteral("Young's modulus")).isEmpty());
    EXPECT_FALSE(value(QStringLiteral("modulus × √radius")).isEmpty());
    EXPECT_FALSE(part<QPushButton>("openFit").isEnabled()) << "no tip is named";
}

TEST_F(CurveFitControlTest, EachStepIsDrawn) {
    nameTip();
    ASSERT_TRUE(opens(folder.write("a.txt", elasticTable("base [um]\tforce [nN]\n"))));
    auto& step = part<QComboBox>("curveStep");
    for (int i = 0; i < step.count(); ++i) {
        step.setCurrentIndex(i);
        const bool isSimulated = i > 0 && i < step.count() - 1;
        EXPECT_EQ(page.plot().measured().approach.isEmpty(), !isSimulated) << i;
        EXPECT_FALSE(page.plot().cycles().front().approach.isEmpty()) << i;
    }
    EXPECT_GT(part<QTableWidget>("curveSteps").rowCount(), 2);
}

TEST_F(CurveFitControlTest, SaysWhyThereIsNoFit) {
    ASSERT_TRUE(opens(folder.write("a.csv", "1,2,3\n4,5,6\n")));
    EXPECT_TRUE(part<QLabel>("curveReasons").text().contains(QStringLiteral("no line names")));
    EXPECT_FALSE(part<QPushButton>("saveFit").isEnabled());
    ASSERT_TRUE(opens(folder.write("b.txt", elasticTable("base [um]\tforce [nN]\n"))));
    EXPECT_TRUE(part<QLabel>("curveVerdict").text().contains(QStringLiteral("refused")));
    EXPECT_TRUE(part<QLabel>("curveReasons").text().contains(QStringLiteral("spring constant")))
        << part<QLabel>("curveReasons").text().toStdString();
}

TEST_F(CurveFitControlTest, ATableIsReadByNamedColumns) {
    const auto file = folder.write("bare.txt", elasticTable(""));
    CurveColumnsDialog dialog(file, {}, nullptr);
    auto& open = *dialog.findChild<QPushButton*>();
    auto& names = *dialog.findChild<QLineEdit*>(QStringLiteral("columnNames"));
    auto& said = *dialog.findChild<QLabel*>(QStringLiteral("columnsFound"));
    names.setText(QStringLiteral("base=1:um,force=7:nN"));
    EXPECT_FALSE(said.text().contains(QStringLiteral("samples"))) << said.text().toStdString();
    names.setText(QStringLiteral("base=1:um,force=2:nN"));
    EXPECT_EQ(said.text(), QStringLiteral("601 samples can be read"));
    EXPECT_TRUE(open.isEnabled());
    nameTip();
    ASSERT_TRUE(opens(file, dialog.options()));
    EXPECT_NEAR(modulus(), 100.0, 0.5);
}

TEST_F(CurveFitControlTest, AnotherCurveOfAMapIsAnotherFit) {
    ASPERITY_NEEDS_SHARED_DATA();
    ASSERT_TRUE(opens(sharedData("curves/original/20200903_Egel2.0_00023.spm")));
    EXPECT_TRUE(part<QLabel>("curvePlace").text().contains(QStringLiteral("of 256")));
    const QString before = value(QStringLiteral("contact point"));
    QSignalSpy shown(&control, &CurveFitControl::shown);
    part<QSpinBox>("curveIndex").setValue(10);
    part<QSpinBox>("curveIndex").setValue(100);
    ASSERT_TRUE(eventually([&] { return shown.count() == 1; })) << "the last one asked for alone";
    EXPECT_NE(value(QStringLiteral("contact point")), before);
    EXPECT_TRUE(part<QLabel>("curvePlace").text().contains(QStringLiteral("column 5, row 7")))
        << part<QLabel>("curvePlace").text().toStdString();
}

}  // namespace
}  // namespace asperity::test
