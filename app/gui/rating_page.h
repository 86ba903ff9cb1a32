#pragma once
// Purpose: one model to be rated: the 3D view, the question, five buttons (keys 1 to 5). Shows nothing that tells how the model was
// made: one grey surface in the same surroundings, always in full detail, always seen from anterior first.

#include <QElapsedTimer>
#include <QWidget>
#include <array>
#include <memory>

#include "app/gui/translated.h"
#include "reconstruction/evaluation/rating.h"
#include "viewer/model_view.h"

class QLabel;
class QPushButton;

namespace glisson {

/// What stands around the models of one subject, the same for each of them: vessels and tumours [3.4].
struct RatedSurroundings {
  std::vector<Structure> structures;  ///< with surfaces
  std::vector<std::shared_ptr<const DisplayMesh>> ready;
};
/// Those of the structures that have a surface and are vessels or lesions. Any thread.
RatedSurroundings surroundingsOf(const LiverModel& model);

/// A model to be rated, ready to be shown.
struct RatedSurface {
  RatedModel model;
  std::shared_ptr<const LiverModel> shown;
  std::vector<std::shared_ptr<const DisplayMesh>> ready;
};
/// Any thread. The mesh is not empty.
RatedSurface ratedSurface(RatedModel model, SurfaceMesh mesh, const RatedSurroundings& surroundings = {});

/// "Very low" to "Very high".
QString ratingTag(int value);

class RatingPage : public Translated<QWidget> {
  Q_OBJECT
 public:
  explicit RatingPage(QWidget* parent);

  /// Shows the model and starts its clock. `number` counts from 1.
  void showModel(const RatedSurface& model, const QString& question, std::size_t number, std::size_t total);
  /// The clock of the model rests until goOn().
  void pause();
  void goOn();

 signals:
  /// A button or key; the seconds are those that the model was seen.
  void rated(const glisson::Rating& rating);
  void pauseRequested();

 protected:
  void retranslateUi() override;
  void keyPressEvent(QKeyEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void rate(int value);
  /// True where the key rates. A key that is held down rates once.
  bool rateByKey(const QKeyEvent& event);

  QLabel* progress_;
  QPushButton* pause_;
  ModelView* view_;
  QLabel* question_;
  std::array<QPushButton*, kHighestRating> buttons_{};
  QElapsedTimer clock_;  ///< not valid while it rests
  qint64 earlierMs_ = 0;
  std::size_t number_ = 0;
  std::size_t total_ = 0;
};

}  // namespace glisson
