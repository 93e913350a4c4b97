// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Paints a view: the renderer's picture in its panels, marks at positions in it, and texts around it. [main]
#pragma once

#include <QCoreApplication>
#include <QImage>
#include <QPainter>
#include <QPixmap>
#include <QString>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "console/view3d/panels.hpp"
#include "console/view3d/scene_marks.hpp"
#include "console/view3d/shown.hpp"

namespace swage::console {

/// The renderer's last picture, with the panels and the moment for which it was drawn; no moment before the first snapshot.
struct Picture {
  QImage image;
  std::vector<Panel> panels;
  std::shared_ptr<snapshot::Snapshot> moment;
};

/// Texts over a picture; "" for none.
struct ViewWords {
  QString clock, banner, hint;
  QString task, message;  // for a trainee's view, beside clock and verdict
};

/// The widget to paint on.
struct Canvas {
  QSize size;
  double ratio = 1;  // device pixels per pixel of the widget
  QPoint origin;     // on the screen, in device pixels
  QFont font;
  bool focus = false;
};

class ScenePainter {
  Q_DECLARE_TR_FUNCTIONS(ScenePainter)

 public:
  ScenePainter(const SceneState& scene, const Shown& shown, const ViewPoint& point, const SceneMarks& marks)
      : scene_(scene), shown_(shown), point_(point), marks_(marks) {}
  /// `leads`: mouse and keys drive a tool.
  void paint(QPainter& painter, const Canvas& canvas, const std::vector<Panel>& panels, const Picture& picture, const ViewWords& words, bool leads);
  /// The separate pictures of the eyes, as paint() composes them. Only for layouts with eyes.
  std::vector<QImage> eyes(const Canvas& canvas, const std::vector<Panel>& panels, const Picture& picture, const ViewWords& words, bool leads);
  /// The text shown without OpenGL.
  void paint_placeholder(QPainter& painter, const Canvas& canvas, const QString& why);
  /// A mark of a registration, mm from the middle of the picture, +y up.
  void set_station_mark(const std::optional<QPointF>& at_mm) { station_mark_ = at_mm; }
  /// The size or the colours of the background changed.
  void forget_background() { background_ = {}; }

 private:
  /// Constants of one painting, shared by all panels.
  struct Job {
    const Canvas& canvas;
    const std::vector<Panel>& panels;
    const Picture& picture;
    const ViewWords& words;
    bool leads;
  };
  const Panel* drawn(const Job& job, size_t panel) const;
  void paint_panel(QPainter& painter, const Job& job, const Panel& panel, size_t index);
  std::vector<QImage> eyes(const Job& job);
  void paint_eyes(QPainter& painter, const Job& job);
  void paint_background(QPainter& painter, const Canvas& canvas, const QRectF& at);
  QString corner_words() const;
  void paint_eye_words(QPainter& painter, Overlay& overlay, const Job& job, const Panel& panel) const;
  void paint_station_mark(QPainter& painter, const Panel& panel) const;
  void paint_frame(QPainter& painter, const Panel& inset) const;
  QString wound_words() const;
  void paint_words(QPainter& painter, const Job& job) const;
  static std::pair<double, double> lower_edge(const Job& job);
  static QRectF scale_place(const Job& job);
  static std::pair<double, double> beside_scale(const Job& job);

  const SceneState& scene_;
  const Shown& shown_;
  const ViewPoint& point_;
  const SceneMarks& marks_;
  std::optional<QPointF> station_mark_;
  QPixmap background_;
};

}  // namespace swage::console
