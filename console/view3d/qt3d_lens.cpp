// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/view3d/qt3d_lens.hpp"

#include <QVector2D>
#include <QVector4D>
#include <Qt3DRender/QCameraSelector>
#include <Qt3DRender/QCullFace>
#include <Qt3DRender/QDepthTest>
#include <Qt3DRender/QLayerFilter>
#include <Qt3DRender/QMaterial>
#include <Qt3DRender/QNoDepthMask>
#include <Qt3DRender/QRenderPass>
#include <Qt3DRender/QRenderTargetOutput>
#include <Qt3DRender/QRenderTargetSelector>
#include <Qt3DRender/QTexture>
#include <Qt3DRender/QTextureWrapMode>

#include "console/view3d/qt3d_geometry.hpp"
#include "console/view3d/qt3d_material.hpp"

namespace swage::console {
namespace {

using namespace Qt3DRender;

constexpr int kReduced = 4;  // pixels of the picture per pixel of the small copy, in each direction

const char* const kVertex = R"(#version 330 core
in vec3 vertexPosition;
out vec2 uv;
void main() {
  uv = 0.5 * vertexPosition.xy + 0.5;
  gl_Position = vec4(vertexPosition.xy, 0.0, 1.0);
})";

// Blur of a pixel, 0..1, from its depth: the diameter of its disc over that of the blurred copy, at most 1. lens: focus distance,
// that ratio per mm off the focus, and the two numbers a, b of the projection by which z = b / (depth + a).
const char* const kUnsharp = R"(
uniform sampler2D depth;
uniform vec4 lens;
float unsharp(vec2 at) {
  float z = lens.w / (2.0 * texture(depth, at).r - 1.0 + lens.z);
  return clamp(lens.y * abs(z - lens.x), 0.0, 1.0);
})";
const char* const kVersion = "#version 330 core\n";

// A quarter of the size: the mean of 16 pixels, weighted by blur, so that sharp objects get no halo. Alpha is that of the
// picture, which is premultiplied.
const char* const kReduce = R"(
in vec2 uv;
out vec4 fragColor;
uniform sampler2D colour;
uniform vec2 texel;
void main() {
  vec4 sum = vec4(0.0);
  float weight = 0.0;
  for (int i = 0; i < 4; ++i) {
    vec2 at = uv + texel * vec2((i & 1) == 0 ? -1.0 : 1.0, i < 2 ? -1.0 : 1.0);
    float w = 0.02 + unsharp(at);
    sum += w * texture(colour, at);
    weight += w;
  }
  fragColor = sum / weight;
})";

// blur by nine taps on a disc, radius six pixels of the picture
const char* const kBlur = R"(
in vec2 uv;
out vec4 fragColor;
uniform sampler2D colour;
uniform vec2 texel;
void main() {
  vec2 r = 6.0 * texel, s = 4.2 * texel;
  vec4 sum = texture(colour, uv);
  sum += texture(colour, uv + vec2(r.x, 0.0)) + texture(colour, uv - vec2(r.x, 0.0));
  sum += texture(colour, uv + vec2(0.0, r.y)) + texture(colour, uv - vec2(0.0, r.y));
  sum += texture(colour, uv + s) + texture(colour, uv - s);
  sum += texture(colour, uv + vec2(s.x, -s.y)) + texture(colour, uv - vec2(s.x, -s.y));
  fragColor = sum / 9.0;
})";

const char* const kMix = R"(
in vec2 uv;
out vec4 fragColor;
uniform sampler2D colour;
uniform sampler2D blurred;
void main() {
  fragColor = mix(texture(colour, uv), texture(blurred, uv), unsharp(uv));
})";

QAbstractTexture* make_texture(Qt3DCore::QNode* parent) {
  auto* texture = new QTexture2D(parent);
  texture->setFormat(QAbstractTexture::RGBA8_UNorm);
  texture->setGenerateMipMaps(false);
  texture->setMinificationFilter(QAbstractTexture::Linear);
  texture->setMagnificationFilter(QAbstractTexture::Linear);
  texture->setWrapMode(QTextureWrapMode(QTextureWrapMode::ClampToEdge));
  return texture;
}

}  // namespace

LensPasses::LensPasses(Qt3DCore::QNode* parent) {
  for (int i = 0; i < 3; ++i) layers_.push_back(new QLayer(parent));
}

void LensPasses::build(QFrameGraphNode* graph, Qt3DCore::QNode* root, QAbstractTexture* colour, QAbstractTexture* depth, QCamera* camera) {
  awake_ = new QSubtreeEnabler(graph);
  awake_->setEnabled(false);
  const Pass small = add_pass(root, camera, 0, kVersion + std::string(kUnsharp) + kReduce, {{"colour", colour}, {"depth", depth}});
  const Pass wide = add_pass(root, camera, 1, kVersion + std::string(kBlur), {{"colour", small.texture}});
  const Pass mixed = add_pass(root, camera, 2, kVersion + std::string(kUnsharp) + kMix, {{"colour", colour}, {"depth", depth}, {"blurred", wide.texture}});
  texture_ = {small.texture, wide.texture, mixed.texture};
  result_ = mixed.target;
}

// Draws one triangle over a whole target.
LensPasses::Pass LensPasses::add_pass(Qt3DCore::QNode* root, QCamera* camera, size_t layer, const std::string& fragment,
                                      const std::vector<std::pair<const char*, QAbstractTexture*>>& reads) {
  auto* selector = new QRenderTargetSelector(awake_);
  auto* target = new QRenderTarget(selector);
  auto* output = new QRenderTargetOutput(target);
  output->setAttachmentPoint(QRenderTargetOutput::Color0);
  QAbstractTexture* texture = make_texture(output);
  output->setTexture(texture);
  target->addOutput(output);
  selector->setTarget(target);
  auto* filter = new QLayerFilter(selector);
  filter->addLayer(layers_[layer]);
  (new QCameraSelector(filter))->setCamera(camera);

  auto* entity = new Qt3DCore::QEntity(root);
  auto* geometry = new MeshGeometry(entity);
  Mesh all;
  for (const auto& [x, y] : {std::pair{-1.F, -1.F}, {3.F, -1.F}, {-1.F, 3.F}}) all.vertex.push_back({{x, y, 0}, {0, 0, 1}});
  all.index = {0, 1, 2};
  geometry->set(all);
  auto* material = new QMaterial(entity);
  QRenderPass* pass = add_technique(material, kVertex, fragment.c_str());
  auto* always = new QDepthTest(pass);
  always->setDepthFunction(QDepthTest::Always);
  auto* both_sides = new QCullFace(pass);
  both_sides->setMode(QCullFace::NoCulling);
  for (QRenderState* state : std::initializer_list<QRenderState*>{always, both_sides, new QNoDepthMask(pass)}) pass->addRenderState(state);
  for (const auto& [name, read] : reads) material->addParameter(new QParameter(QString::fromLatin1(name), read, material));
  lens_.push_back(add_parameter(material, "lens"));
  texel_.push_back(add_parameter(material, "texel"));
  lens_.back()->setValue(QVector4D());
  texel_.back()->setValue(QVector2D());
  entity->addComponent(geometry);
  entity->addComponent(material);
  entity->addComponent(layers_[layer]);
  return {target, texture};
}

void LensPasses::set(const Lens& lens, const QMatrix4x4& projection) {
  awake_->setEnabled(lens.on);
  if (!lens.on) return;
  // depth = -a + b / z for a frustum, with z the distance from the eye
  const float a = projection(2, 2), b = projection(2, 3);
  for (QParameter* p : lens_) p->setValue(QVector4D(lens.focus_mm, lens.aperture * lens.px_per_mm / kDisc_px, a, b));
}

void LensPasses::resize(const QSize& pixels) {
  const QSize small = (pixels / kReduced).expandedTo({1, 1});
  for (size_t i = 0; i < texture_.size(); ++i) {
    const QSize& size = i < 2 ? small : pixels;
    texture_[i]->setSize(size.width(), size.height());
  }
  for (QParameter* p : texel_) p->setValue(QVector2D(1 / static_cast<float>(pixels.width()), 1 / static_cast<float>(pixels.height())));
}

}  // namespace swage::console
