// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The interface between view and renderer, free of Qt3D, so that Qt3D can be replaced (it is deprecated since
// Qt 6.8).
#pragma once

#include <QColor>
#include <QImage>
#include <QMatrix4x4>
#include <QRect>
#include <QSize>
#include <QString>
#include <QVector3D>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "console/view3d/clear_sight.hpp"
#include "console/view3d/eye.hpp"
#include "console/view3d/medium_look.hpp"
#include "console/view3d/mesh.hpp"

namespace swage::console {

/// Surface texture at high magnification.
enum class Finish {
  kPlain,
  kMoist,    // living tissue: mottled, uneven, with a film of water
  kBrushed,  // steel with machining marks along x of the mesh
  kGhost,    // a translucent object with bright outline; drawn last and without a shadow
};

/// Reflection of light.
struct Surface {
  QColor colour{150, 150, 150};
  float metal = 0;   // 0 matte .. 1 polished steel
  float gloss = 24;  // exponent of the highlight
  Finish finish = Finish::kPlain;
};

/// The level of the shadows and the grid; mm.
struct Floor {
  bool shown = false;
  float z = 0;
  QVector3D centre;
  float radius = 10;                   // where the floor has faded out
  float half_x = 1e6F, half_y = 1e6F;  // half size, where the floor ends
  float fill = 1;                      // opacity between the lines; 0: only the lines, over a surface that is drawn already
  float grid = 1;                      // distance between lines
  float shadow = 0.068F;               // darkness of one layer of a shadow
  float reach = 4;                     // height above which a shadow is faint
  QColor colour{70, 84, 84}, line{96, 112, 112};
};

/// Whether a part casts a shadow, and on which level.
struct Casts {
  bool on_floor = false, on_shelf = false;
};

/// An eye, and its rectangle in the picture, in pixels from the top left.
struct View {
  Eye eye;
  QRect part;
};

/// Depth of field: the blur disc of a point has the diameter aperture x its distance from the focal plane, measured in that plane.
struct Lens {
  bool on = false;
  float focus_mm = 1;   // from the eyes to the focal plane
  float aperture = 0;   // width of the lens over the focus distance
  float px_per_mm = 1;  // in the focal plane
};

/// Largest diameter of a blur disc: that of the blur's taps and of one of its pixels. Larger discs are drawn with this one.
inline constexpr float kDisc_px = 14;

/// Whether this machine can draw, and if not, why. Probed once at start.
struct GlProbe {
  bool ok = false, software = false;
  QString why, renderer;
};
GlProbe probe_gl();
/// Whether the driver has quad-buffered stereo, for shutter glasses. Probed once.
bool has_quad_buffers();

/// Draws parts, each with its pose. All calls from the GUI thread.
class Renderer {
 public:
  virtual ~Renderer() = default;
  virtual void clear() = 0;
  virtual int add_part(const Mesh& mesh, const Surface& surface, Casts casts) = 0;
  /// Removes this part and all parts added after it.
  virtual void drop_from(int part) = 0;
  virtual void set_mesh(int part, const Mesh& mesh) = 0;  // for flexible objects: new triangles every picture
  virtual void set_pose(int part, const QMatrix4x4& X_WB_mm) = 0;
  virtual void set_surface(int part, const Surface& surface) = 0;
  virtual void set_visible(int part, bool visible) = 0;
  virtual void set_floor(const Floor& floor) = 0;
  /// A second level, which receives only shadows.
  virtual void set_shelf(const Floor& shelf) = 0;
  /// At most as many as the renderer was made for; unused ones are disabled.
  virtual void set_views(std::span<const View> views) = 0;
  /// The disc that instruments (Finish::kBrushed) must not hide, in all views.
  virtual void set_clear_sight(const ClearSight& sight) = 0;
  /// The medium in which all solid parts are seen.
  virtual void set_medium(const MediumLook& look) = 0;
  /// The lens of all views, which have the same near and far plane; to be called after set_views().
  virtual void set_lens(const Lens& lens) = 0;
  virtual void resize(const QSize& pixels) = 0;
  /// Draws one picture; `done` receives this or an earlier one, with transparent background, premultiplied.
  virtual void draw(std::function<void(const QImage&)> done) = 0;
};

/// `samples`: per pixel, 1 for none.
std::unique_ptr<Renderer> make_qt3d_renderer(int samples, int most_views);

}  // namespace swage::console
