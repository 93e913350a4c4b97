// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The pictures of the Review page: the attempt's, and beside it that of another attempt, with its instruments seen through in the first.
#pragma once

#include <QHBoxLayout>
#include <QList>
#include <QWidget>
#include <memory>

#include "console/link/reviewed_attempt.hpp"
#include "console/models/reading.hpp"
#include "console/view3d/scene_view.hpp"

namespace swage::console {

class Comparison;

class ReviewPictures : public QWidget {
  Q_OBJECT
 public:
  /// The attempt outlives the pictures.
  ReviewPictures(const ReviewedAttempt& attempt, QWidget* parent);
  ~ReviewPictures() override;
  void set_themes(const UiTheme& ui, const CueTheme& cues);
  /// Gives another view the colours of these pictures.
  void set_colours(SceneView& view) const { view.set_themes(ui_, cues_); }
  /// Shows the scene of the attempt that was opened, if it has one.
  void show_scene();
  /// Plays all scenes towards a time of the attempt, by at most `most` steps each, and shows them; true when they are there. `wanted_s`: the cursor.
  bool toward(double wanted_s, uint64_t most);

  /// Shows another attempt of the store beside this one. Returns "" or the error.
  QString compare(const QString& attempt_id);
  void end_comparison();
  bool comparing() const;
  Comparison* other() { return other_; }
  void toggle_ghost();

  SceneView* view() { return view_; }
  /// Another view of the attempt, a trainee's; it shows the attempt until it is removed or destroyed.
  void add_view(SceneView* view);
  void remove_view(SceneView* view);
  void look(CameraPreset preset);

 Q_SIGNALS:
  /// Another time of the other attempt lies beside this one's.
  void aligned();
  void ended();
  /// Meanings of the cues that are on.
  void cues_on(const QStringList& meanings);
  /// From this time on the replay is not the recorded attempt bit for bit.
  void differs(double from_s);

 private:
  void show_player(double wanted_s);
  void dress(SceneView* view);
  void set_ghost();
  void move_ghost();

  const ReviewedAttempt& attempt_;
  std::unique_ptr<snapshot::Snapshot> snapshot_;
  Reader reading_;
  UiTheme ui_;
  CueTheme cues_;
  SceneView* view_;
  QList<SceneView*> views_;  // the page's own first
  double wanted_s_ = 0;
  QHBoxLayout* row_;
  QVBoxLayout* column_;
  Comparison* other_ = nullptr;  // made on first use
};

}  // namespace swage::console
