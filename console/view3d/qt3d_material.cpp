// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/view3d/qt3d_material.hpp"

#include <QVector2D>
#include <QVector4D>
#include <Qt3DRender/QBlendEquation>
#include <Qt3DRender/QBlendEquationArguments>
#include <Qt3DRender/QCullFace>
#include <Qt3DRender/QDepthTest>
#include <Qt3DRender/QEffect>
#include <Qt3DRender/QGraphicsApiFilter>
#include <Qt3DRender/QNoDepthMask>
#include <Qt3DRender/QShaderProgram>
#include <Qt3DRender/QTechnique>

namespace swage::console {
Qt3DRender::QRenderPass* add_technique(Qt3DRender::QMaterial* material, const char* vertex, const char* fragment) {
  using namespace Qt3DRender;
  auto* effect = new QEffect(material);
  auto* technique = new QTechnique(effect);
  technique->graphicsApiFilter()->setApi(QGraphicsApiFilter::OpenGL);
  technique->graphicsApiFilter()->setProfile(QGraphicsApiFilter::CoreProfile);
  technique->graphicsApiFilter()->setMajorVersion(3);
  technique->graphicsApiFilter()->setMinorVersion(3);
  auto* pass = new QRenderPass(technique);
  auto* program = new QShaderProgram(pass);
  program->setVertexShaderCode(vertex);
  program->setFragmentShaderCode(fragment);
  pass->setShaderProgram(program);
  technique->addRenderPass(pass);
  effect->addTechnique(technique);
  material->setEffect(effect);
  return pass;
}

Qt3DRender::QParameter* add_parameter(Qt3DRender::QMaterial* material, const char* name) {
  auto* parameter = new Qt3DRender::QParameter(QString::fromLatin1(name), QVariant(), material);
  material->addParameter(parameter);
  return parameter;
}

namespace {

const char* const kSolidVertex = R"(#version 330 core
in vec3 vertexPosition;
in vec3 vertexNormal;
out vec3 position;
out vec3 normal;
out vec3 place;
out vec3 world;
uniform mat4 modelMatrix;
uniform mat4 modelView;
uniform mat3 modelViewNormal;
uniform mat4 mvp;
void main() {
  normal = modelViewNormal * vertexNormal;
  position = vec3(modelView * vec4(vertexPosition, 1.0));
  place = vertexPosition;
  world = vec3(modelMatrix * vec4(vertexPosition, 1.0));
  gl_Position = mvp * vec4(vertexPosition, 1.0);
})";

#define SWAGE_TEXT_OF(...) #__VA_ARGS__
#define SWAGE_TEXT(...) SWAGE_TEXT_OF(__VA_ARGS__)

// Lights are fixed to the camera, as under a microscope: shapes are lit from every viewpoint. Steel mirrors a small
// studio: dark floor, grey wall, two soft boxes. Tissue is mottled, reddish where it faces away from the light, with a
// wet film on an uneven surface; jaws are brushed along their length.
const char* const kSolidFragment = R"(#version 330 core
in vec3 position;
in vec3 normal;
in vec3 place;
in vec3 world;
out vec4 fragColor;
uniform vec3 eyePosition;
uniform vec3 clear_centre;
uniform vec2 clear_size;  // radius, depth that is kept
uniform float clear_fade;
uniform vec3 colour;
uniform float metal;
uniform float gloss;
uniform float finish;
uniform vec4 veil;  // colour, share per mm
uniform vec2 film;  // on tissue, on what is plain
const vec3 key = vec3(-0.408, 0.707, 0.577);
const vec3 fill = vec3(0.802, 0.100, 0.589);
float studio(vec3 r) {
  float wall = mix(0.40, 0.80, smoothstep(-0.8, 0.8, r.y));
  float box_key = smoothstep(0.66, 0.95, dot(r, key));
  float box_fill = smoothstep(0.80, 0.97, dot(r, fill));
  return wall + 0.45 * box_key + 0.25 * box_fill;
}
// so that the cells of the noise lie along no edge
const mat3 askew = mat3(0.00, 0.80, 0.60, -0.80, 0.36, -0.48, -0.60, -0.48, 0.64);
float scatter(vec3 p) {
  p = fract(p * vec3(0.1031, 0.1030, 0.0973));
  p += dot(p, p.yxz + 33.33);
  return fract((p.x + p.y) * p.z);
}
// 0..1, smooth over cells of 1
float noise(vec3 p) {
  vec3 i = floor(p), f = fract(p);
  f = f * f * (3.0 - 2.0 * f);
  vec4 low = vec4(scatter(i), scatter(i + vec3(1, 0, 0)), scatter(i + vec3(0, 1, 0)), scatter(i + vec3(1, 1, 0)));
  i.z += 1.0;
  vec4 high = vec4(scatter(i), scatter(i + vec3(1, 0, 0)), scatter(i + vec3(0, 1, 0)), scatter(i + vec3(1, 1, 0)));
  vec4 at = mix(low, high, f.z);
  return mix(mix(at.x, at.y, f.x), mix(at.z, at.w, f.x), f.y);
}
// the normal of the surface raised by `height` mm, from how both change from pixel to pixel
vec3 raised(vec3 n, float height) {
  vec3 along = dFdx(position), up = dFdy(position);
  vec3 a = cross(up, n), b = cross(n, along);
  float det = dot(along, a);
  return normalize(abs(det) * n - sign(det) * (dFdx(height) * a + dFdy(height) * b));
}
)" SWAGE_TEXT(SWAGE_CLEAR_SIGHT_FORMULA) R"(
float cleared() {
  return clear_size.x <= 0.0 ? 0.0 : hides(eyePosition, clear_centre, world, clear_size.x, clear_size.y, clear_fade);
}
// Pixels of an ordered 4 x 4 screen: a surface that is half there needs no order of drawing.
bool left_out() {
  ivec2 p = ivec2(gl_FragCoord.xy) & 3;
  int q = p.x ^ p.y;
  float threshold = (float(((q & 1) << 3) | ((p.y & 1) << 2) | (q & 2) | ((p.y & 2) >> 1)) + 0.5) / 16.0;
  return cleared() > threshold;
}
// reflection of a film of water
float wet(vec3 r, float facing) {
  float glint = pow(max(dot(r, key), 0.0), 110.0) + 0.6 * pow(max(dot(r, fill), 0.0), 110.0);
  return (0.04 + 0.5 * pow(1.0 - facing, 4.0)) * studio(r) + 0.55 * glint;
}
void main() {
  vec3 n = normalize(normal);
  vec3 v = normalize(-position);
  vec3 c0 = colour;
  if (finish > 1.5) {
    if (left_out()) discard;
    c0 *= 0.95 + 0.10 * noise(vec3(1.5 * place.x, 55.0 * place.yz));
  } else if (finish > 0.5) {
    vec3 skew = askew * place;
    float coarse = noise(0.9 * skew), middle = noise(2.3 * (askew * skew)), fine = noise(7.0 * skew);
    float flushed = smoothstep(0.30, 0.80, 0.55 * coarse + 0.30 * middle + 0.15 * fine);
    c0 *= mix(vec3(1.0), vec3(0.95, 0.80, 0.78), flushed);
    n = raised(n, 0.05 * coarse + 0.03 * middle + 0.008 * fine);
  } else if (film.y > 0.0) {
    n = raised(n, 0.05 * noise(0.8 * world) + 0.03 * noise(2.1 * world));
  }
  vec3 r = reflect(-v, n);
  float facing = max(dot(n, v), 0.0);
  float diffuse = 0.48 + 0.12 * n.y + 0.42 * max(dot(n, key), 0.0) + 0.22 * max(dot(n, fill), 0.0);
  float highlight = pow(max(dot(r, key), 0.0), gloss);
  float rim = pow(1.0 - facing, 3.0);
  vec3 matte = c0 * diffuse + vec3(0.22 * highlight + 0.10 * rim);
  if (finish > 0.5 && finish < 1.5) {
    vec3 glow = mix(vec3(1.0, 0.74, 0.70), vec3(1.0), smoothstep(0.45, 1.0, diffuse));
    matte = c0 * diffuse * glow + vec3(film.x * wet(r, facing));
  } else if (film.y > 0.0) {
    matte += vec3(film.y * wet(r, facing));
  }
  vec3 steel = c0 * (0.72 * studio(r) + 0.34 * diffuse) * (0.9 + 0.4 * rim) + vec3(0.25 * highlight);
  vec3 c = mix(matte, steel, metal);
  if (veil.w > 0.0) c = mix(veil.rgb, c, exp(-veil.w * length(position)));
  // a shoulder instead of a hard white
  c = min(c, 0.75 + 0.25 * (1.0 - exp(-max(c - 0.75, 0.0) / 0.25)));
  fragColor = vec4(c, 1.0);
})";

// premultiplied alpha: glass with a bright outline
const char* const kGhostFragment = R"(#version 330 core
in vec3 position;
in vec3 normal;
in vec3 place;
out vec4 fragColor;
uniform vec3 colour;
void main() {
  float facing = abs(dot(normalize(normal), normalize(-position)));
  float a = mix(0.30, 0.85, pow(1.0 - facing, 1.5));
  fragColor = vec4(colour * a, a);
})";

const char* const kFloorVertex = R"(#version 330 core
in vec3 vertexPosition;
out vec2 place;
uniform mat4 modelMatrix;
uniform mat4 mvp;
void main() {
  place = vec2(modelMatrix * vec4(vertexPosition, 1.0));
  gl_Position = mvp * vec4(vertexPosition, 1.0);
})";

// premultiplied alpha: the floor fades into the background
const char* const kFloorFragment = R"(#version 330 core
in vec2 place;
out vec4 fragColor;
uniform vec3 colour;
uniform vec3 line;
uniform vec3 centre;
uniform vec2 extent;
uniform float radius;
uniform float grid;
uniform float fill;
float lines(vec2 p, vec2 w, float thick) {
  vec2 d = abs(fract(p - 0.5) - 0.5) / w;
  vec2 on = clamp(thick - d, 0.0, 1.0) * clamp(0.5 / w, 0.0, 1.0);
  return max(on.x, on.y);
}
void main() {
  vec2 p = place / grid;
  vec2 w = max(fwidth(p), vec2(1e-6));
  float fine = 0.45 * lines(p, w, 1.0);
  float coarse = lines(p / 5.0, w / 5.0, 1.3);
  float fade = 1.0 - smoothstep(0.25, 1.0, length(place - centre.xy) / radius);
  vec2 inside = step(abs(place - centre.xy), extent);
  float on = max(fine, coarse);
  vec3 c = mix(colour, line, on);
  float a = 0.94 * fade * inside.x * inside.y * max(fill, on);
  fragColor = vec4(c * a, a);
})";

// Projects the parts on to the floor along several directions of an area light: the shadow is sharp where
// something touches and soft where it hovers, which conveys height.
const char* const kShadowVertex = R"(#version 330 core
in vec3 vertexPosition;
out vec3 place;
uniform mat4 modelMatrix;
uniform mat4 viewProjectionMatrix;
uniform float floor_z;
const float golden = 2.399963;
void main() {
  vec3 p = vec3(modelMatrix * vec4(vertexPosition, 1.0));
  float i = float(gl_InstanceID);
  vec2 lamp = vec2(0.30, 0.18) + 0.10 * sqrt((i + 0.5) / 8.0) * vec2(cos(i * golden), sin(i * golden));
  float height = p.z - floor_z;
  place = vec3(p.xy + lamp * height, height);
  gl_Position = viewProjectionMatrix * vec4(place.xy, floor_z, 1.0);
})";

const char* const kShadowFragment = R"(#version 330 core
in vec3 place;
out vec4 fragColor;
uniform vec3 centre;
uniform vec2 extent;
uniform float radius;
uniform float reach;
uniform float strength;
const float sunk = -0.06;  // mm: what rests may start a little inside, what goes deeper is hidden there
void main() {
  float fade = 1.0 - smoothstep(0.25, 1.0, length(place.xy - centre.xy) / radius);
  vec2 inside = step(abs(place.xy - centre.xy), extent);
  float near = exp(-max(place.z, 0.0) / reach);
  float above = step(sunk, place.z);
  fragColor = vec4(0.0, 0.0, 0.0, strength * fade * near * above * inside.x * inside.y);
})";

// premultiplied blending with depth test but without depth writes
void lay_over(Qt3DRender::QRenderPass* pass, Qt3DRender::QCullFace::CullingMode culling) {
  using namespace Qt3DRender;
  auto* blend = new QBlendEquationArguments(pass);
  blend->setSourceRgba(QBlendEquationArguments::One);
  blend->setDestinationRgba(QBlendEquationArguments::OneMinusSourceAlpha);
  auto* equation = new QBlendEquation(pass);
  equation->setBlendFunction(QBlendEquation::Add);
  auto* depth = new QDepthTest(pass);
  depth->setDepthFunction(QDepthTest::Less);
  auto* cull = new QCullFace(pass);
  cull->setMode(culling);
  for (QRenderState* state :
       std::initializer_list<QRenderState*>{blend, equation, depth, cull, new QNoDepthMask(pass)}) {
    pass->addRenderState(state);
  }
}

// the lights work in a space between sRGB and linear, which keeps theme colours
// recognisable
QVector3D shade(const QColor& c) {
  return {static_cast<float>(c.redF()), static_cast<float>(c.greenF()), static_cast<float>(c.blueF())};
}

}  // namespace

SolidMaterial::SolidMaterial(Qt3DCore::QNode* parent)
    : QMaterial(parent),
      clear_centre_(add_parameter(this, "clear_centre")),
      clear_size_(add_parameter(this, "clear_size")),
      veil_(add_parameter(this, "veil")),
      film_(add_parameter(this, "film")),
      colour_(add_parameter(this, "colour")),
      metal_(add_parameter(this, "metal")),
      gloss_(add_parameter(this, "gloss")),
      finish_(add_parameter(this, "finish")) {
  add_parameter(this, "clear_fade")->setValue(kClearFade);
  add_technique(this, kSolidVertex, kSolidFragment);
  set(ClearSight());
  set(MediumLook());
  set(Surface());
}

void SolidMaterial::set(const Surface& s) {
  colour_->setValue(shade(s.colour));
  metal_->setValue(s.metal);
  gloss_->setValue(s.gloss);
  finish_->setValue(static_cast<float>(s.finish));
}

void SolidMaterial::set(const ClearSight& sight) {
  clear_centre_->setValue(sight.centre);
  clear_size_->setValue(QVector2D(sight.radius, sight.kept));
}

void SolidMaterial::set(const MediumLook& look) {
  veil_->setValue(QVector4D(shade(look.veil), look.veil_per_mm));
  film_->setValue(QVector2D(look.tissue_film, look.stage_film));
}

GhostMaterial::GhostMaterial(Qt3DCore::QNode* parent) : QMaterial(parent), colour_(add_parameter(this, "colour")) {
  lay_over(add_technique(this, kSolidVertex, kGhostFragment), Qt3DRender::QCullFace::Back);
  set({});
}

void GhostMaterial::set(const Surface& s) { colour_->setValue(shade(s.colour)); }

FloorMaterial::FloorMaterial(Qt3DCore::QNode* parent)
    : QMaterial(parent),
      colour_(add_parameter(this, "colour")),
      line_(add_parameter(this, "line")),
      centre_(add_parameter(this, "centre")),
      half_(add_parameter(this, "extent")),
      radius_(add_parameter(this, "radius")),
      grid_(add_parameter(this, "grid")),
      fill_(add_parameter(this, "fill")) {
  lay_over(add_technique(this, kFloorVertex, kFloorFragment), Qt3DRender::QCullFace::NoCulling);
  set({});
}

void FloorMaterial::set(const Floor& f) {
  colour_->setValue(shade(f.colour));
  line_->setValue(shade(f.line));
  centre_->setValue(f.centre);
  radius_->setValue(f.radius);
  half_->setValue(QVector2D(f.half_x, f.half_y));
  grid_->setValue(f.grid);
  fill_->setValue(f.fill);
}

ShadowMaterial::ShadowMaterial(Qt3DCore::QNode* parent)
    : QMaterial(parent),
      centre_(add_parameter(this, "centre")),
      half_(add_parameter(this, "extent")),
      radius_(add_parameter(this, "radius")),
      floor_z_(add_parameter(this, "floor_z")),
      strength_(add_parameter(this, "strength")),
      reach_(add_parameter(this, "reach")) {
  // one layer per direction: only faces towards the lamp
  lay_over(add_technique(this, kShadowVertex, kShadowFragment), Qt3DRender::QCullFace::Back);
  set({});
}

void ShadowMaterial::set(const Floor& f) {
  centre_->setValue(f.centre);
  radius_->setValue(f.radius);
  floor_z_->setValue(f.z);
  half_->setValue(QVector2D(f.half_x, f.half_y));
  strength_->setValue(f.shadow);
  reach_->setValue(f.reach);
}

}  // namespace swage::console
