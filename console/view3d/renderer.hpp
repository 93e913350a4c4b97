// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What the view asks of a renderer, free of Qt3D: another one can take its place (Qt3D is deprecated since
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
#include "console/view3d/mesh.hpp"

namespace swage::console {

/// What a surface is like at a close look.
enum class Finish {
  kPlain,
  kMoist,    // living tissue: mottled, uneven, with a film of water
  kBrushed,  // steel with marks of its making along x of the mesh
  kGhost,    // something that is not there: its outline, seen through; over everything else, and without a shadow
};

/// How a surface answers light.
struct Surface {
  QColor colour{150, 150, 150};
  float metal = 0;   // 0 matte .. 1 polished steel
  float gloss = 24;  // exponent of the highlight
  Finish finish = Finish::kPlain;
};

/// The level where shadows fall and the grid lies; mm.
struct Floor {
  bool shown = false;
  float z = 0;
  QVector3D centre;
  float radius = 10;                   // fades out there
  float half_x = 1e6F, half_y = 1e6F;  // and ends here
  float fill = 1;                      // 0: only the lines, over a surface that is already there
  float grid = 1;                      // between lines
  float shadow = 0.068F;               // darkness of one of the layers of a shadow
  float reach = 4;                     // height at which a shadow is faint
  QColor colour{70, 84, 84}, line{96, 112, 112};
};

/// Where a part casts its shadow.
struct Casts {
  bool on_floor = false, on_shelf = false;
};

/// An eye, and the part of the picture that is its own, in pixels from the top left.
struct View {
  Eye eye;
  QRect part;
};

/// Depth of field: a point so far off the plane in focus is seen as a disc of so many times that diameter in that plane.
struct Lens {
  bool on = false;
  float focus_mm = 1;   // from the eyes to the plane that is sharp
  float aperture = 0;   // width of the lens over its distance
  float px_per_mm = 1;  // in that plane
};

/// Diameter of the largest disc that is drawn: that of the taps of the blur and of one of its pixels. A larger one shows as this.
inline constexpr float kDisc_px = 14;

/// Whether this machine can draw, and why not. Asked once at start.
struct GlProbe {
  bool ok = false, software = false;
  QString why, renderer;
};
GlProbe probe_gl();
/// Whether the driver has a left and a right buffer for glasses that shut in turn. Asked once.
bool has_quad_buffers();

/// Draws parts with a pose each. All calls from the GUI thread.
class Renderer {
 public:
  virtual ~Renderer() = default;
  virtual void clear() = 0;
  virtual int add_part(const Mesh& mesh, const Surface& surface, Casts casts) = 0;
  /// Takes away this part and those that were added after it.
  virtual void drop_from(int part) = 0;
  virtual void set_mesh(int part, const Mesh& mesh) = 0;  // for threads: new triangles every picture
  virtual void set_pose(int part, const QMatrix4x4& X_WB_mm) = 0;
  virtual void set_surface(int part, const Surface& surface) = 0;
  virtual void set_visible(int part, bool visible) = 0;
  virtual void set_floor(const Floor& floor) = 0;
  /// A second level on which only shadows fall.
  virtual void set_shelf(const Floor& shelf) = 0;
  /// At most as many as the renderer was made for; the others sleep.
  virtual void set_views(std::span<const View> views) = 0;
  /// What instruments (Finish::kBrushed) must not hide, in all views.
  virtual void set_clear_sight(const ClearSight& sight) = 0;
  /// For all views, which have the same near and far plane; after set_views().
  virtual void set_lens(const Lens& lens) = 0;
  virtual void resize(const QSize& pixels) = 0;
  /// Draws one picture; `done` gets an earlier or this one, with transparent background, premultiplied.
  virtual void draw(std::function<void(const QImage&)> done) = 0;
};

/// `samples`: per pixel, 1 for none.
std::unique_ptr<Renderer> make_qt3d_renderer(int samples, int most_views);

}  // namespace swage::console
