// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Paints a view: the renderer's picture in its panels, what belongs to places in it, and words around it. [main]
#pragma once

#include <QCoreApplication>
#include <QImage>
#include <QPainter>
#include <QPixmap>
#include <QString>
#include <optional>
#include <utility>
#include <vector>

#include "console/view3d/panels.hpp"
#include "console/view3d/scene_marks.hpp"
#include "console/view3d/shown.hpp"

namespace swage::console {

/// The renderer's last picture, and its panels as they were when it was drawn.
struct Picture {
  QImage image;
  std::vector<Panel> panels;
};

/// What is said over a picture; "" for nothing.
struct ViewWords {
  QString clock, banner, hint;
  QString task, message;  // of a trainee's view, which shows them beside clock and verdict
};

/// The widget that is painted on.
struct Canvas {
  QSize size;
  double ratio = 1;  // device pixels of one of its pixels
  QPoint origin;     // on the screen, in its pixels
  QFont font;
  bool focus = false;
};

class ScenePainter {
  Q_DECLARE_TR_FUNCTIONS(ScenePainter)

 public:
  ScenePainter(const SceneState& scene, const Shown& shown, const ViewPoint& point, const SceneMarks& marks)
      : scene_(scene), shown_(shown), point_(point), marks_(marks) {}
  /// `leads`: mouse and keys lead a tool.
  void paint(QPainter& painter, const Canvas& canvas, const std::vector<Panel>& panels, const Picture& picture, const ViewWords& words, bool leads);
  /// The pictures of the eyes by themselves, as paint() lays them on or beside each other. Only for two eyes or one.
  std::vector<QImage> eyes(const Canvas& canvas, const std::vector<Panel>& panels, const Picture& picture, const ViewWords& words, bool leads);
  /// Where there is no OpenGL.
  void paint_placeholder(QPainter& painter, const Canvas& canvas, const QString& why);
  /// A mark of a registration, mm from the middle of the picture, +y up.
  void set_station_mark(const std::optional<QPointF>& at_mm) { station_mark_ = at_mm; }
  /// Size or colours of the background are others.
  void forget_background() { background_ = {}; }

 private:
  /// One painting: what does not change from panel to panel.
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
  void paint_eye_words(QPainter& painter, Overlay& overlay, const Job& job, const Panel& panel) const;
  void paint_station_mark(QPainter& painter, const Panel& panel) const;
  void paint_frame(QPainter& painter, const Panel& inset) const;
  QString wound_words() const;
  void paint_words(QPainter& painter, const Job& job) const;
  static std::pair<double, double> lower_edge(const Job& job);

  const SceneState& scene_;
  const Shown& shown_;
  const ViewPoint& point_;
  const SceneMarks& marks_;
  std::optional<QPointF> station_mark_;
  QPixmap background_;
};

}  // namespace swage::console
