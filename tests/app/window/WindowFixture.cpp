#include "tests/app/window/WindowFixture.h"

#include "app/window/recording/RecordingControl.h"
#include "app/window/scene/LibraryControl.h"
#include "tests/support/TestScenes.h"
#include "ui/view/ZoomView.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QStatusBar>
#include <QStringList>
#include <QWheelEvent>
#include <QtTest>

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace asperity::test {

std::filesystem::path levelScan(ScratchFolder& folder, int side) {
    const std::string count = std::to_string(side);
    const std::string size = count + "e-9";
    std::string bytes = "Gwyddion Simple Field 1.0\nXRes = " + count + "\nYRes = " + count +
                        "\nXReal = " + size + "\nYReal = " + size +
                        "\nXYUnits = m\nZUnits = m\nTitle = Height\n";
    bytes.append(4 - bytes.size() % 4, '\0');
    bytes.append(sizeof(float) * static_cast<std::size_t>(side) * static_cast<std::size_t>(side),
                 '\0');
    return folder.write("level" + count + ".gsf", bytes);
}

void Window::live(int milliseconds) { QTest::qWait(milliseconds); }

bool Window::framesPass() {
    long fetched = stage.run()->fetchCost().ticks;
    const auto isAnother = [&] {
        return std::exchange(fetched, stage.run()->fetchCost().ticks) != fetched;
    };
    return eventually(isAnother) && eventually(isAnother);
}

bool Window::runsFor(double seconds) {
    double ran = 0.0;
    double last = tickTime();
    const auto hasRun = [&] {
        const double now = tickTime();
        ran += std::max(0.0, now - last);  // another run begins at 0
        last = now;
        return ran >= seconds;
    };
    return eventually(hasRun) && framesPass();
}

bool Window::baseRests() {
    constexpr double kRest = 0.2;       // [s]
    constexpr double kUnmoved = 1e-14;  // [m]
    Vector3 position = stage.run()->basePosition();
    double since = tickTime();
    return eventually([&] {
        const Vector3 here = stage.run()->basePosition();
        const double now = tickTime();
        if ((here - position).norm() > kUnmoved || now < since) {
            position = here;
            since = now;
        }
        return now - since >= kRest;
    });
}

double Window::tickTime() { return stage.run()->loop().snapshot().sample.time; }

void Window::SetUp() {
    for (const char* const home : {"XDG_CONFIG_HOME", "XDG_DATA_HOME"}) {
        qputenv(home, folder.path().c_str());  // of programs that are started
    }
    stage.get<RecordingControl>().setFolder(folder.path() / "recordings");
    stage.get<MaterialControl>().setFolder(folder.path() / "materials");
    stage.get<ProbeControl>().setFolder(folder.path() / "probes");
    window.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
    QApplication::setActiveWindow(&window);  // a bare X server has nobody who does so
}

void Window::openFlatScene(const SceneDescription& description) {
    stage.runs().use({.scene = buildScene(description, flatMap()),
                      .format = "made for the test",
                      .sha256 = "",
                      .notes = {}});
    ASSERT_TRUE(eventually([this] { return state().find("far") != std::string::npos; })) << state();
}

std::string Window::text(const char* label) { return child<QLabel>(label)->text().toStdString(); }

double Window::number(const char* label) {
    static const std::map<QString, double> kUnits{
        {"fN", 1e-15}, {"pN", 1e-12}, {"nN", 1e-9}, {"µN", 1e-6}, {"fm", 1e-15},
        {"pm", 1e-12}, {"nm", 1e-9},  {"µm", 1e-6}, {"N", 1.0},   {"m", 1.0}};
    const QStringList words = child<QLabel>(label)->text().replace("−", "-").split(' ');
    if (words.size() != 2 || !kUnits.contains(words[1])) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    return words[0].toDouble() * kUnits.at(words[1]);
}

// A list that drops down would need a user's click on it.
void Window::choose(const char* list, const QString& entry) {
    auto* box = child<QComboBox>(list);
    const int index = box->findText(entry);
    ASSERT_GE(index, 0) << entry.toStdString();
    box->setCurrentIndex(index);
    Q_EMIT box->activated(index);
}

bool Window::changeEnds() {
    return eventually(
        [this] { return *stage.edits().wanted() == stage.run()->scene().description; });
}

void Window::turn(const char* knob, const QString& number) {
    auto* box = child<QAbstractSpinBox>(knob);
    box->setFocus();
    box->selectAll();
    QTest::keyClicks(box, number);
    QTest::keyClick(box, Qt::Key_Return);
}

std::string Window::told() { return window.statusBar()->currentMessage().toStdString(); }

void Window::press(Qt::Key key, Qt::KeyboardModifiers modifiers) {
    QTest::keyPress(&panels.view(), key, modifiers);
}

void Window::release(Qt::Key key) { QTest::keyRelease(&panels.view(), key); }

// QTest::mouseMove() tells of no pressed button.
void Window::drag(const QPoint& from, const QPoint& to) {
    QTest::mousePress(&panels.view(), Qt::LeftButton, Qt::NoModifier, from);
    QMouseEvent move(QEvent::MouseMove, to, panels.view().mapToGlobal(to), Qt::NoButton,
                     Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&panels.view(), &move);
    QTest::mouseRelease(&panels.view(), Qt::LeftButton, Qt::NoModifier, to);
}

void Window::turnWheel(int notches, Qt::KeyboardModifiers modifiers) {
    const QPointF middle = panels.view().rect().center();
    QWheelEvent event(middle, panels.view().mapToGlobal(middle.toPoint()), {}, {0, 120 * notches},
                      Qt::NoButton, modifiers, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&panels.view(), &event);
}

}  // namespace asperity::test
