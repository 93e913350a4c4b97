// SPDX-License-Identifier: LGPL-3.0-or-later
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QPointer>
#include <Qt3DCore/QAspectEngine>
#include <Qt3DCore/QCoreAspect>
#include <Qt3DCore/QEntity>
#include <Qt3DCore/QTransform>
#include <Qt3DRender/QCameraLens>
#include <Qt3DRender/QRenderAspect>
#include <Qt3DRender/QRenderSettings>

#include "console/view3d/qt3d_geometry.hpp"
#include "console/view3d/qt3d_material.hpp"
#include "console/view3d/qt3d_target.hpp"
#include "console/view3d/renderer.hpp"

namespace swage::console {
namespace {

// the surface outlives the engine: with the other order Qt 6.4 crashes at exit
class Qt3dRenderer final : public Renderer {
 public:
  Qt3dRenderer(int samples, int most_views) {
    surface_.setFormat(QSurfaceFormat::defaultFormat());
    surface_.create();
    engine_.setRunMode(Qt3DCore::QAspectEngine::Manual);
    engine_.registerAspect(new Qt3DCore::QCoreAspect);
    engine_.registerAspect(new Qt3DRender::QRenderAspect);
    root_ = new Qt3DCore::QEntity;
    auto* settings = new Qt3DRender::QRenderSettings(root_);
    root_->addComponent(settings);
    target_ = std::make_unique<PictureTarget>(root_, &surface_, samples, most_views);
    settings->setActiveFrameGraph(target_->root());
    add_floor();
    engine_.setRootEntity(Qt3DCore::QEntityPtr(root_));
  }

  ~Qt3dRenderer() override { engine_.setRootEntity(Qt3DCore::QEntityPtr()); }

  void clear() override { drop_from(0); }

  void drop_from(int first) override {
    for (; parts_.size() > static_cast<size_t>(first); parts_.pop_back()) {
      for (Shadow& shadow : parts_.back().shadow) delete shadow.entity;
      delete parts_.back().entity;
    }
  }

  int add_part(const Mesh& mesh, const Surface& surface, Casts casts) override {
    Part part;
    part.entity = new Qt3DCore::QEntity(root_);
    part.geometry = new MeshGeometry(part.entity);
    part.geometry->set(mesh);
    part.transform = new Qt3DCore::QTransform(part.entity);
    part.entity->addComponent(part.geometry);
    add_material(part, surface);
    part.entity->addComponent(part.transform);
    part.shadow[0].wanted = casts.on_floor;
    part.shadow[1].wanted = casts.on_shelf;
    for (size_t level = 0; level < 2; ++level)
      if (part.shadow[level].wanted) add_shadow(part.shadow[level], *shadow_material_[level], mesh);
    parts_.push_back(part);
    return static_cast<int>(parts_.size()) - 1;
  }

  void set_mesh(int part, const Mesh& mesh) override {
    at(part).geometry->set(mesh);
    for (Shadow& shadow : at(part).shadow)
      if (shadow.entity) shadow.geometry->set(mesh);
  }
  void set_pose(int part, const QMatrix4x4& X) override {
    at(part).transform->setMatrix(X);
    for (Shadow& shadow : at(part).shadow)
      if (shadow.entity) shadow.transform->setMatrix(X);
  }
  void set_surface(int part, const Surface& surface) override {
    if (at(part).ghost) return at(part).ghost->set(surface);
    at(part).material->set(surface);
  }
  void set_visible(int part, bool visible) override {
    at(part).entity->setEnabled(visible);
    show_shadows(at(part));
  }

  void set_floor(const Floor& floor) override {
    floor_entity_->setEnabled(floor.shown);
    floor_material_->set(floor);
    set_level(0, floor);
    QMatrix4x4 m;
    m.translate(floor.centre.x(), floor.centre.y(), floor.z);
    m.scale(std::min(floor.radius, floor.half_x), std::min(floor.radius, floor.half_y), 1);
    floor_transform_->setMatrix(m);
  }

  void set_shelf(const Floor& shelf) override { set_level(1, shelf); }

  void set_lens(const Lens& lens) override { target_->set_lens(lens, target_->camera(0)->lens()->projectionMatrix()); }

  void set_clear_sight(const ClearSight& sight) override {
    if (sight == clear_sight_) return;
    clear_sight_ = sight;
    for (Part& part : parts_)
      if (part.material) part.material->set(sight);
  }

  void set_medium(const MediumLook& look) override {
    if (look == medium_) return;
    medium_ = look;
    for (Part& part : parts_)
      if (part.material) part.material->set(look);
  }

  void set_views(std::span<const View> views) override {
    for (size_t i = 0; i < target_->most_views(); ++i) {
      if (i >= views.size()) {
        target_->hide(i);
        continue;
      }
      const auto& [eye, part] = views[i];
      const double w = size_.width(), h = size_.height();
      // Qt3D truncates to whole pixels: a rounding error downwards would shift a view by one pixel to the left and falsify the depth
      constexpr double kNudge_px = 0.25;
      target_->show(i, {(part.x() + kNudge_px) / w, (part.y() + kNudge_px) / h, (part.width() + kNudge_px) / w,
                        (part.height() + kNudge_px) / h});
      Qt3DRender::QCamera* camera = target_->camera(i);
      camera->lens()->setProjectionMatrix(eye.projection);
      camera->setPosition(eye.position);
      camera->setUpVector(eye.up);
      camera->setViewCenter(eye.ahead);
    }
  }

  void resize(const QSize& pixels) override {
    size_ = pixels.expandedTo({1, 1});
    target_->resize(size_);
  }

  void draw(std::function<void(const QImage&)> done) override {
    Qt3DRender::QRenderCaptureReply* reply = target_->capture()->requestCapture();
    QObject::connect(reply, &Qt3DRender::QRenderCaptureReply::completed, reply,
                     [reply, done = std::move(done)] {
                       QImage image = reply->image();
                       image.reinterpretAsFormat(QImage::Format_ARGB32_Premultiplied);
                       done(image);
                       reply->deleteLater();
                     });
    engine_.processFrame();
  }

 private:
  struct Shadow {
    bool wanted = false;
    Qt3DCore::QEntity* entity = nullptr;
    MeshGeometry* geometry = nullptr;
    Qt3DCore::QTransform* transform = nullptr;  // components with a pose are not shared
  };
  struct Part {
    Qt3DCore::QEntity* entity = nullptr;
    MeshGeometry* geometry = nullptr;
    SolidMaterial* material = nullptr;  // one of the two is set
    GhostMaterial* ghost = nullptr;
    Qt3DCore::QTransform* transform = nullptr;
    Shadow shadow[2];  // one on the floor, one on the shelf
  };
  Part& at(int part) { return parts_[static_cast<size_t>(part)]; }

  void add_material(Part& part, const Surface& surface) {
    if (surface.finish == Finish::kGhost) {
      part.ghost = new GhostMaterial(part.entity);
      part.ghost->set(surface);
      part.entity->addComponent(part.ghost);
      part.entity->addComponent(target_->ghost_layer());
      return;
    }
    part.material = new SolidMaterial(part.entity);
    part.material->set(surface);
    part.material->set(clear_sight_);
    part.material->set(medium_);
    part.entity->addComponent(part.material);
  }

  void add_shadow(Shadow& shadow, ShadowMaterial& material, const Mesh& mesh) {
    shadow.entity = new Qt3DCore::QEntity(root_);
    shadow.geometry = new MeshGeometry(shadow.entity);
    shadow.geometry->set(mesh);
    shadow.geometry->setInstanceCount(kShadowLayers);
    shadow.entity->addComponent(shadow.geometry);
    shadow.entity->addComponent(&material);
    shadow.transform = new Qt3DCore::QTransform(shadow.entity);
    shadow.entity->addComponent(shadow.transform);
    shadow.entity->addComponent(target_->shadow_layer());
  }

  void show_shadows(Part& part) {
    for (size_t level = 0; level < 2; ++level)
      if (part.shadow[level].entity)
        part.shadow[level].entity->setEnabled(level_shown_[level] && part.entity->isEnabled());
  }

  void set_level(size_t level, const Floor& floor) {
    level_shown_[level] = floor.shown;
    shadow_material_[level]->set(floor);
    for (Part& part : parts_) show_shadows(part);
  }

  void add_floor() {
    for (ShadowMaterial*& material : shadow_material_) material = new ShadowMaterial(root_);
    floor_entity_ = new Qt3DCore::QEntity(root_);
    auto* geometry = new MeshGeometry(floor_entity_);
    Mesh square;
    for (const auto& [x, y] : {std::pair{-1.F, -1.F}, {1.F, -1.F}, {1.F, 1.F}, {-1.F, 1.F}}) {
      square.vertex.push_back({{x, y, 0}, {0, 0, 1}});
    }
    square.index = {0, 1, 2, 0, 2, 3};
    geometry->set(square);
    floor_material_ = new FloorMaterial(floor_entity_);
    floor_transform_ = new Qt3DCore::QTransform(floor_entity_);
    floor_entity_->addComponent(geometry);
    floor_entity_->addComponent(floor_material_);
    floor_entity_->addComponent(floor_transform_);
    floor_entity_->addComponent(target_->floor_layer());
    floor_entity_->setEnabled(false);
  }

  QOffscreenSurface surface_;
  Qt3DCore::QAspectEngine engine_;
  Qt3DCore::QEntity* root_ = nullptr;  // the engine owns it, and everything below
  std::unique_ptr<PictureTarget> target_;
  std::vector<Part> parts_;
  ClearSight clear_sight_;
  MediumLook medium_;
  Qt3DCore::QEntity* floor_entity_ = nullptr;
  FloorMaterial* floor_material_ = nullptr;
  ShadowMaterial* shadow_material_[2] = {};
  bool level_shown_[2] = {};
  Qt3DCore::QTransform* floor_transform_ = nullptr;
  QSize size_{1, 1};
};

}  // namespace

GlProbe probe_gl() {
  GlProbe probe;
  QSurfaceFormat format;
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  QOpenGLContext context;
  context.setFormat(format);
  if (!context.create()) {
    probe.why = QStringLiteral("no OpenGL driver answers");
    return probe;
  }
  QOffscreenSurface surface;
  surface.setFormat(context.format());
  surface.create();
  if (!surface.isValid() || !context.makeCurrent(&surface)) {
    probe.why = QStringLiteral("OpenGL has no surface to draw on");
    return probe;
  }
  const GLubyte* name = context.functions()->glGetString(GL_RENDERER);
  probe.renderer = QString::fromLatin1(reinterpret_cast<const char*>(name));
  probe.software = probe.renderer.contains(QLatin1String("llvmpipe")) ||
                   probe.renderer.contains(QLatin1String("softpipe"));
  probe.ok = context.format().version() >= qMakePair(3, 3);
  if (!probe.ok) probe.why = QStringLiteral("OpenGL 3.3 is needed");
  context.doneCurrent();
  return probe;
}

bool has_quad_buffers() {
  static const bool has = [] {
    constexpr GLenum kStereo = 0x0C33;  // GL_STEREO, which not every header has
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setStereo(true);
    QOpenGLContext context;
    context.setFormat(format);
    if (!context.create()) return false;
    QOffscreenSurface surface;
    surface.setFormat(context.format());
    surface.create();
    if (!surface.isValid() || !context.makeCurrent(&surface)) return false;
    GLboolean stereo = GL_FALSE;
    context.functions()->glGetBooleanv(kStereo, &stereo);
    context.doneCurrent();
    return stereo == GL_TRUE;
  }();
  return has;
}

std::unique_ptr<Renderer> make_qt3d_renderer(int samples, int most_views) {
  return std::make_unique<Qt3dRenderer>(samples, most_views);
}

}  // namespace swage::console
