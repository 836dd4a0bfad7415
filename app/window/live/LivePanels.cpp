#include "app/window/live/LivePanels.h"

#include "app/window/live/CantileverPanel.h"
#include "app/window/live/ControlBar.h"
#include "app/window/live/EngageBar.h"
#include "app/window/live/ForcePanel.h"
#include "app/window/live/LoopStatusBar.h"
#include "app/window/live/OverviewPanel.h"
#include "app/window/live/StateBanner.h"
#include "ui/shell/CardColumn.h"
#include "ui/shell/Host.h"
#include "ui/shell/Menus.h"
#include "ui/shell/WorkInBackground.h"
#include "ui/view/ColorScale.h"
#include "ui/view/ColorsMenu.h"
#include "ui/view/OverviewMap.h"
#include "ui/view/SecondView.h"
#include "ui/view/ViewOptionsMenu.h"
#include "ui/view/ZoomView.h"
#include "ui/widgets/Theme.h"

#include <QAction>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QSplitter>
#include <QStackedLayout>
#include <QVBoxLayout>

namespace asperity {

namespace {

/// Smallest size of the large view, whatever else is open [px, as theme::scaled() takes them].
constexpr QSize kLeastView(180, 160);
constexpr int kHalf = 1000;  // of the width, for each view once both are shown

/// The keys that move the device work again once a knob is turned.
void giveFocusBack(ControlBar& controls, ZoomView& view) {
    const auto toView = [&view] { view.setFocus(); };
    const auto give = [&](auto chosen) { QObject::connect(&controls, chosen, &view, toView); };
    give(&ControlBar::runningChosen);
    give(&ControlBar::forcesChosen);
    give(&ControlBar::materialChosen);
    give(&ControlBar::deviceChosen);
    give(&ControlBar::pathChosen);
    give(&ControlBar::recordingChosen);
    for (QLineEdit* number : controls.findChildren<QLineEdit*>()) {
        QObject::connect(number, &QLineEdit::returnPressed, &view, toView);
    }
}

/// A right click on a color bar chooses other colors; a button beside it, those of the dent alone.
void chooseColorsBy(const ViewBars& bars, ColorsMenu& colors) {
    QObject::connect(&bars, &ViewBars::colorsRequested, &colors,
                     [&colors](const QPoint& at) { colors.menu().popup(at); });
    QObject::connect(&bars, &ViewBars::dentOnlyChosen, &colors, [&colors](bool isOnly) {
        SurfaceLook look = colors.look();
        look.quantity = isOnly ? SurfaceQuantity::Displacement : SurfaceQuantity::Height;
        colors.choose(look);
    });
}

/// The overview shows where the view looks.
void showFrameOf(const ZoomView& view, OverviewPanel& overview) {
    QObject::connect(&view, &ZoomView::frameChanged, &overview, [&] {
        if (const auto window = view.window()) {
            overview.showFrame(
                QRectF(QPointF(window->left, window->bottom), QPointF(window->right, window->top)));
        }
    });
}

}  // namespace

/// Hints in one line: as many as fit, the first ones.
class HintLine : public QLabel {
public:
    explicit HintLine(QWidget* parent) : QLabel(parent) {
        setAlignment(Qt::AlignCenter);
        setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    }

    void setTexts(const QStringList& texts) {
        texts_ = texts;
        fit();
    }

protected:
    void resizeEvent(QResizeEvent* event) override {
        QLabel::resizeEvent(event);
        fit();
    }

private:
    void fit() {
        QStringList shown = texts_;
        const auto joined = [&shown] { return shown.join(QStringLiteral("   ·   ")); };
        while (shown.size() > 1 && fontMetrics().horizontalAdvance(joined()) > width()) {
            shown.removeLast();
        }
        setText(joined());
    }

    QStringList texts_;
};

/// The large view with what belongs to it: above it the banner and Engage, below it the color bars
/// and a line with a hint, or with what is being loaded.
class ViewSide : public QWidget {
public:
    struct Parts {
        StateBanner* banner;
        EngageBar* engage;
        ZoomView* view;
        SecondView* second;  ///< beside it
        LoadingBar* loading;
    };

    ViewSide(const Parts& parts, QWidget* parent)
        : QWidget(parent)
        , parts_(parts)
        , column_(new QVBoxLayout(this))
        , views_(newSplitter(Qt::Horizontal, "views", this))
        , bars_(new ViewBars(*parts.view, this)) {
        column_->setContentsMargins(0, 0, 0, 0);
        column_->setSpacing(kPanelGap);
        column_->addWidget(parts.banner);
        column_->addWidget(parts.engage);
        parts.view->setMinimumSize(theme::scaled(kLeastView.width()),
                                   theme::scaled(kLeastView.height()));
        views_->addWidget(parts.view);
        views_->addWidget(parts.second);
        views_->setStretchFactor(0, 1);
        views_->setStretchFactor(1, 1);
        views_->setSizes({kHalf, kHalf});
        column_->addWidget(views_, 1);
        column_->addWidget(bars_);
        addBottomLine();
    }

    [[nodiscard]] QSplitter& views() { return *views_; }
    [[nodiscard]] QVBoxLayout& column() { return *column_; }
    [[nodiscard]] ViewBars& bars() const { return *bars_; }
    void setHints(const QStringList& hints) { hint_->setTexts(hints); }
    /// Sets whether the last line shows the loading instead of the hint.
    void setLoading(bool loading) { bottomLine_->setCurrentIndex(loading ? 1 : 0); }

private:
    /// Hint and loading in one line, so that nothing moves when a file is loaded.
    void addBottomLine() {
        hint_ = new HintLine(this);
        hint_->setObjectName(QStringLiteral("hint"));
        hint_->setToolTip(tr("Mouse actions in the large view; keys: Help > Keyboard and mouse"));
        parts_.view->setAccessibleDescription(
            tr("The sample around the tip, the tip and the force on it, in three dimensions"));
        bottomLine_ = new QStackedLayout;
        bottomLine_->addWidget(hint_);
        bottomLine_->addWidget(parts_.loading);
        column_->addLayout(bottomLine_);
    }

    Parts parts_;
    QVBoxLayout* column_;
    QSplitter* views_;
    ViewBars* bars_;
    HintLine* hint_ = nullptr;
    QStackedLayout* bottomLine_ = nullptr;  ///< hint, loading
};

LivePanels::LivePanels(Host& host)
    : host_(host)
    , controls_(new ControlBar(&host.widget()))
    , banner_(new StateBanner(&host.widget()))
    , engage_(new EngageBar(&host.widget()))
    , view_(new ZoomView(&host.widget()))
    , second_(new SecondView(&host.widget()))
    , loading_(new LoadingBar(&host.widget()))
    , side_(new ViewSide({banner_, engage_, view_, second_, loading_}, &host.widget()))
    , overview_(new OverviewPanel(&host.widget()))
    , forces_(new ForcePanel(&host.widget()))
    , loopStatus_(new LoopStatusBar(&host.widget())) {
    host.setMiddle({.top = controls_,
                    .views = side_,
                    .split = &side_->views(),
                    .showViews = [this] { secondEntry_->setChecked(true); },
                    .banner = banner_,
                    .column = &side_->column()});
    leaving_.setSingleShot(true);
    leaving_.setInterval(0);
    placeCards();
    addEntries();
    connectViews();
    connectWorks();
    giveFocusBack(*controls_, *view_);
    connect(engage_, &EngageBar::setpointEntered, view_, [this] { view_->setFocus(); });
    showScene(nullptr, {});
    controls_->setEnabled(false);  // until there is something to control
    engage_->setEnabled(false);
    showLoading({});
    setEmergencyStop(false);
    view_->setFocus();
}

LivePanels::~LivePanels() = default;

void LivePanels::placeCards() {
    const auto add = [this](auto* card, int share) {
        host_.addCard(*card, share);
        panels_.push_back(card);
    };
    panels_.push_back(banner_);
    add(forces_, 4);
    add(new CantileverPanel(&host_.widget()), 3);
    add(overview_, 3);
    host_.addStatus(*loopStatus_);
    panels_.push_back(loopStatus_);
}

QSplitter& LivePanels::views() { return side_->views(); }

std::optional<Vector2> LivePanels::crossHair() const { return crossHair_->position(); }

void LivePanels::addEntries() {
    Menus& menus = host_.menus();
    cancelLoading_ = &menus.add(
        {MenuName::File, 0, 50}, "cancelLoading",
        {.text = tr("C&ancel loading"), .tip = tr("Stop loading; the scene stays as it is")});
    const auto add = [&](int rank, const char* name, const MenuEntry& entry, auto what) {
        connect(&menus.add({MenuName::View, 0, rank}, name, entry), &QAction::triggered, this,
                what);
    };
    add(10, "zoomIn",
        {.text = tr("Zoom &in"),
         .tip = tr("Show a smaller part of the scan"),
         .shortcuts = {QKeySequence::ZoomIn}},
        [this] { view_->setHalfWidth(view_->halfWidth() / 1.25); });
    add(20, "zoomOut",
        {.text = tr("Zoom &out"),
         .tip = tr("Show a larger part of the scan"),
         .shortcuts = {QKeySequence::ZoomOut}},
        [this] { view_->setHalfWidth(view_->halfWidth() * 1.25); });
    add(30, "resetView",
        {.text = tr("&Reset the view"),
         .tip = tr("Restores the default direction and width"),
         .shortcuts = {tr("Home")}},
        [this] { view_->resetCamera(); });
    directions_ =
        new DirectionMenu(menus.addMenu({MenuName::View, 1, 10}, "directions", tr("&Direction")),
                          DirectionMenu::Keys::Digits);
    secondEntry_ =
        &menus.add({MenuName::View, 1, 20}, "secondView",
                   {.text = tr("Second vie&w"),
                    .tip = tr("Beside the large view: a section through the contact, or a 3-D "
                              "view with a direction and options of its own"),
                    .isCheckable = true});
    secondEntry_->setChecked(true);
    colors_ = new ColorsMenu(menus.addMenu({MenuName::View, 2, 10}, "colors", tr("&Colors")));
    const QAction& timing = menus.add({MenuName::View, 4, 30}, "loopTiming",
                                      {.text = tr("Loop timing in the &bottom line"),
                                       .tip = tr("Time of a tick, lateness, missed ticks and frame "
                                                 "rate in the bottom line"),
                                       .isCheckable = true,
                                       .keptAs = QStringLiteral("view/loopTiming")});
    connect(&timing, &QAction::toggled, loopStatus_, &LoopStatusBar::setDetailed);
    auto* options = new QMenu(&host_.widget());
    viewOptions_ = new ViewOptionsMenu(*options);
    menus.addEntriesOf(*options, {MenuName::View, 2, 20});
}

void LivePanels::connectViews() {
    connect(directions_, &DirectionMenu::sideChosen, view_, &ZoomView::lookFrom);
    connect(directions_, &DirectionMenu::perspectiveChosen, view_, &ZoomView::setPerspective);
    connect(secondEntry_, &QAction::toggled, second_, &QWidget::setVisible);
    connect(viewOptions_, &ViewOptionsMenu::optionsChosen, view_, &ZoomView::setOptions);
    showFrameOf(*view_, *overview_);
    chooseColorsBy(side_->bars(), *colors_);
    chooseColorsBy(second_->bars(), *colors_);
    ColorBarWidget& whole = overview_->colorBar();
    connect(&whole, &QWidget::customContextMenuRequested, this,
            [this, &whole](const QPoint& at) { colors_->menu().popup(whole.mapToGlobal(at)); });
    connect(view_, &ZoomView::scalesChanged, this, [this] {
        const ColorScale shown = view_->colorScale();
        colors_->setShown(shown.unit, shown.low, shown.high);
    });
    crossHair_ = std::make_unique<CrossHairLink>(*view_, *second_, overview_->map());
    // The second view moves the tip as the large one does.
    connect(&second_->space(), &ZoomView::tipDragged, view_, &ZoomView::tipDragged);
    connect(&second_->space(), &ZoomView::lifted, view_, &ZoomView::lifted);
}

void LivePanels::showLook(const SurfaceLook& look, const SurfaceField& field) {
    view_->setLook(look, field);
    second_->setLook(look, field);
    overview_->setLook(look, field);
    colors_->setLook(look);
    const bool isDentOnly = look.quantity == SurfaceQuantity::Displacement;
    side_->bars().setDentOnly(isDentOnly);
    second_->bars().setDentOnly(isDentOnly);
}

void LivePanels::showScene(const Scene* scene, const QString& title) {
    for (RunPanel* const panel : panels_) {
        panel->clear();
        if (scene != nullptr) {
            panel->begin(*scene);
        }
    }
    if (scene != nullptr && !hasShownScene_) {
        hasShownScene_ = true;
        controls_->setEnabled(true);
        engage_->setEnabled(true);
    }
    view_->setScene(scene);
    second_->setScene(scene);
    host_.setTitle(title);
}

void LivePanels::connectWorks() {
    WorkInBackground& works = host_.works();
    connect(&works, &WorkInBackground::named, this, &LivePanels::showLoading);
    connect(&works, &WorkInBackground::progressed, loading_, &LoadingBar::setFraction);
    connect(loading_, &LoadingBar::cancelRequested, &works, &WorkInBackground::cancel);
    connect(cancelLoading_, &QAction::triggered, &works, &WorkInBackground::cancel);
}

void LivePanels::showLoading(const QString& words) {
    loading_->begin(words);
    side_->setLoading(!words.isEmpty());
    cancelLoading_->setEnabled(!words.isEmpty());
}

void LivePanels::setEmergencyStop(bool active) {
    host_.keepEscape(active);
    hasEmergencyStop_ = active;
    showHint();
}

void LivePanels::setDemonstration(bool isPlaying) {
    isDemonstration_ = isPlaying;
    showHint();
}

void LivePanels::refuseTip(const QString& why) {
    controls_->refuseTip(why);
    tipMoves_ = why.isEmpty();
    showHint();
}

void LivePanels::fix(const QString& why) {
    isFixed_ = !why.isEmpty();
    controls_->fix(why);
    engage_->setEnabled(!isFixed_);
    crossHair_->setOn(!isFixed_);  // nothing is looked for with the pointer
    host_.allowChanges(!isFixed_);
}

void LivePanels::showHint() {
    if (isDemonstration_) {
        side_->setHints({tr("Demonstration: click or press a key to take over"),
                         tr("The tip approaches the sample and withdraws by itself")});
        return;
    }
    QStringList hints;
    if (hasEmergencyStop_) {
        hints << tr("Esc: forces off");
    }
    if (tipMoves_) {
        hints << tr("Drag: move the tip") << tr("Wheel: up and down");
    }
    hints << tr("Right drag: turn") << tr("Ctrl + wheel: zoom");
    side_->setHints(hints);
}

bool LivePanels::leaveTool() {
    OverviewMap& map = overview_->map();
    if (map.activeTool() != nullptr) {
        map.activate(nullptr);
        leaving_.start();
    }
    return leaving_.isActive();
}

void LivePanels::lock() {
    controls_->setEnabled(false);
    engage_->setEnabled(false);
    overview_->setEnabled(false);
}

}  // namespace asperity
