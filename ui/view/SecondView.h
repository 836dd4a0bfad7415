#pragma once

#include "core/EnumTable.h"
#include "core/Vector.h"
#include "core/deformation/HalfSpaceModel.h"
#include "core/deformation/SurfaceField.h"
#include "core/haptics/VirtualRun.h"
#include "ui/view/ColorScale.h"
#include "ui/view/Shading.h"
#include "ui/view/SurfacePick.h"

#include <QObject>
#include <QWidget>

#include <memory>
#include <optional>

class QComboBox;
class QHBoxLayout;
class QStackedWidget;
class QToolButton;

namespace asperity {

class ColorBarWidget;
class ContactPlot;
class NumberBox;
class OverviewMap;
class ViewBars;
class ViewOptionsMenu;
class ZoomView;
struct Scene;

/// Content of the second view.
enum class SecondContent : std::uint8_t { Space, Section };

template <>
inline constexpr auto kEnumTable<SecondContent> = std::to_array<EnumRow<SecondContent>>(
    {{SecondContent::Space, "space", "3-D view"}, {SecondContent::Section, "section", "Section"}});

/// Settings of the second view; kept from one session to the next.
struct SecondViewSettings {
    SecondContent content = SecondContent::Section;
    ViewOptions options;         ///< of the 3-D view
    bool followsContact = true;  ///< the section goes through the contact, whatever its direction
    double azimuth = 0.0;        ///< of the section else, from x [degree]
    double heightFactor = 1.0;   ///< of the section; 0: as large as heights fit
};

/// A view beside the large one, with a direction, options and zoom of its own: in 3-D, or a section
/// through the contact. While it is hidden it draws nothing and holds no meshes.
class SecondView : public QWidget {
    Q_OBJECT

public:
    explicit SecondView(QWidget* parent = nullptr);

    /// Null: nothing to show. The scene outlives its use here.
    void setScene(const Scene* scene);
    /// Sets how the surface is colored. @param field the look's quantity on the surface at rest
    void setLook(const SurfaceLook& look, const SurfaceField& field);
    void setHalfSpace(const std::shared_ptr<const HalfSpaceAnswer>& answer);
    /// Draws a frame of the present scene, unless hidden.
    void showSnapshot(const Snapshot& snapshot);
    /// See ZoomPicture: from the next snapshot on.
    void setWrittenForce(const std::string& force);
    void showCrossHair(const std::optional<Vector2>& position,
                       const std::optional<SurfaceReading>& reading);

    [[nodiscard]] SecondViewSettings settings() const;
    void setSettings(const SecondViewSettings& settings);
    [[nodiscard]] ZoomView& space() { return *space_; }
    [[nodiscard]] ContactPlot& section() { return *section_; }
    /// Returns the bars of the 3-D view: its range is that of its own frame.
    [[nodiscard]] ViewBars& bars() const { return *bars_; }

Q_SIGNALS:
    /// The pointer is over this position of the surface at rest, world x, y [m].
    void positionHovered(double x, double y);
    void pointerLeft();

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void addContents();
    void addSpaceControls(QHBoxLayout& row);
    void addSectionControls(QHBoxLayout& row);
    [[nodiscard]] SecondContent content() const;
    void showContent();
    void chooseDirection();
    void showFollowedDirection();
    void useScene(bool visible);

    const Scene* scene_ = nullptr;
    ZoomView* space_;
    ContactPlot* section_;
    ViewBars* bars_;
    QStackedWidget* stack_;
    QComboBox* contents_;
    QWidget* spaceControls_;
    QWidget* sectionControls_;
    ViewOptionsMenu* options_ = nullptr;
    QToolButton* follows_;
    NumberBox* direction_;
    QComboBox* heights_;
};

/// The color bars of a view: that of the quantity, and that of displacements where they are shown
/// over it.
class ViewBars : public QWidget {
    Q_OBJECT

public:
    /// @param view outlives this object
    explicit ViewBars(const ZoomView& view, QWidget* parent = nullptr);

    /// Shows whether displacements alone color the surface.
    void setDentOnly(bool isOnly);

Q_SIGNALS:
    /// A right click asks for another coloring, at this position of the screen.
    void colorsRequested(QPoint at);
    /// The user wants displacements alone to color the surface, or heights again.
    void dentOnlyChosen(bool isOnly);

private:
    void showScales(const ZoomView& view);

    ColorBarWidget* quantity_;
    ColorBarWidget* displacement_;
    QToolButton* dentOnly_;
};

/// One cross-hair for all views: where the pointer is in one, all show the position and what
/// is read there.
class CrossHairLink : public QObject {
public:
    /// All outlive this object.
    CrossHairLink(ZoomView& view, SecondView& second, OverviewMap& map);

    /// World x, y [m]; none: the pointer is over no view.
    [[nodiscard]] const std::optional<Vector2>& position() const { return position_; }

    /// Off, no view shows any.
    void setOn(bool on);

private:
    template <class View>
    void follow(View& view);
    void point(const std::optional<Vector2>& position);
    void showInOthers();

    ZoomView& view_;
    SecondView& second_;
    OverviewMap& map_;
    std::optional<Vector2> position_;
    bool isOn_ = true;
};

}  // namespace asperity
