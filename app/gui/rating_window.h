#pragma once
// Purpose: a blind rating [Palomar 2016, 3.4]: experts rate models one at a time in a random order without being told how they were
// made; at the end the methods are compared. A window of its own. The session is kept in a CSV file that is written after every
// rating, so that it can go on after a pause, a change of raters or a crash.

#include <QWidget>
#include <functional>
#include <optional>
#include <vector>

#include "app/gui/rating_page.h"
#include "app/gui/translated.h"

class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QPushButton;
class QStackedWidget;

namespace glisson {

class RatingResultsPage;

class RatingWindow : public Translated<QWidget> {
  Q_OBJECT
 public:
  /// `surfaces`: at least one, with ids of their own, of `structure`, which the question names. `folder`: where sessions are kept;
  /// made where it is missing.
  RatingWindow(std::vector<RatedSurface> surfaces, Structure structure, QString folder, QWidget* parent);

  /// Nothing before the first rater has started; then it has at least one.
  [[nodiscard]] const std::optional<RatingSession>& session() const { return session_; }
  /// The file that the session is kept in.
  [[nodiscard]] const QString& path() const { return path_; }
  /// Goes on with the session of that file. Throws InputError where it holds none, or one of other models.
  void resume(const QString& path);
  /// Writes the ratings to that file, and what the tests come to beside it. Throws InputError.
  void saveCopy(const QString& path) const;
  /// "A/B-tests.csv" of "A/B.csv".
  static QString testsPathBeside(const QString& path);

 protected:
  void retranslateUi() override;

 private:
  QWidget* makeStartPage();
  [[nodiscard]] QString headingText() const;
  void start();
  void rate(const Rating& rating);
  void pause();
  void showNext();
  void showStart();
  void showResults();
  void chooseSession();
  void chooseCopy();
  void keep(const RatingSession& session) const;
  /// Shows what an action throws; true where it throws nothing.
  bool attempt(const std::function<void()>& action);
  /// Somebody has begun and is to go on.
  [[nodiscard]] bool raterGoesOn() const { return !another_ && session_ && session_->next().has_value(); }

  [[nodiscard]] QString usualQuestion() const;

  std::vector<RatedSurface> surfaces_;  ///< by id, as in the study
  Structure structure_;
  QString folder_;
  QString path_;
  std::optional<RatingSession> session_;
  QString complaint_;  ///< in English; empty: none
  bool questionIsDefault_ = true;
  bool paused_ = false;   ///< the model of the page is the next one, and its clock rests
  bool another_ = false;  ///< the rater who has not finished does not go on; another one is to start

  QLabel* heading_;
  QLabel* explanation_;
  QLabel* questionLabel_;
  QPlainTextEdit* question_;
  QLabel* nameLabel_;
  QLineEdit* name_;
  QPushButton* start_;
  QPushButton* resume_;
  QPushButton* change_;
  QPushButton* results_;
  QLabel* kept_;
  QStackedWidget* pages_;
  QWidget* startPage_;
  RatingPage* ratingPage_;
  RatingResultsPage* resultsPage_;
  QLabel* notice_;
};

}  // namespace glisson
