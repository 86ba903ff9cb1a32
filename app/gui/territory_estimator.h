#pragma once
// Purpose: territories of the portal branches and the plan's effect on the remnant's blood, for the open case: estimated when
// asked, then following the plan. Left and right are proposed until the user confirms them or points at branches; the case keeps
// that. UI thread only.

#include <QObject>
#include <memory>
#include <optional>

#include "app/gui/document.h"
#include "planning/territories/territory_json.h"
#include "reconstruction/io/read.h"

namespace glisson {

class TerritoryEstimator : public QObject {
  Q_OBJECT
 public:
  TerritoryEstimator(JobRunner& jobs, Document& document, QObject* parent = nullptr);

  enum class State : std::uint8_t {
    None,       ///< not asked for
    Computing,  ///< the vessels' trees, once a case
    Following,  ///< known; report() is of an older plan or choice for a moment
    Current
  };
  [[nodiscard]] State state() const { return state_; }
  /// Numbers of the plan as it stands; null unless Current.
  [[nodiscard]] const TerritoryReport* report() const { return state_ == State::Current && report_ ? &*report_ : nullptr; }
  /// Left and right as proposed, and not confirmed yet.
  [[nodiscard]] bool isProposal() const { return !choice_.picks.empty() && !choice_.confirmed; }
  /// What the territories hang on; null unless Following or Current.
  [[nodiscard]] const VesselGraph* portal() const { return perfusion_ && territories_ ? &perfusion_->portal() : nullptr; }
  /// Which of its branches stand for which territory.
  [[nodiscard]] const TerritoryChoice& choice() const { return choice_; }
  [[nodiscard]] bool isPicked() const { return choice_.source == TerritorySource::Picked && !choice_.picks.empty(); }

  void estimate();
  /// A person has looked at the proposed left and right and found them right.
  void confirm();
  /// The supplying portal branch nearest to a point, with all behind it, becomes a territory of its own.
  void pick(const Vec3& pointMm);
  /// A map of segments 1 to 8, a file or a folder of masks, instead of branches.
  void chooseSegments(const QString& path, const ReadOptions& options = {});
  [[nodiscard]] bool hasSegments() const { return choice_.segments.has_value(); }
  /// Back to left and right as proposed.
  void propose();

 signals:
  void changed();
  void refused(const QString& sentence);  ///< in English
  /// The map that was chosen is not read so; the sentence, in English, may be a question (askToRead).
  void mapRefused(const QString& path, const glisson::ReadOptions& options, const QString& sentence);

 private:
  void forget();
  /// A choice that the case keeps and that cannot be had any more (its map of segments is gone) becomes the proposal, with a note.
  /// `step`: what the user did, an undo step of the case once it is done; empty where the case says so already. `newMap`: how a map
  /// is read that the case does not keep yet.
  void divide(TerritoryChoice choice, const QString& step = {}, const std::optional<ReadOptions>& newMap = {});
  void keep(const QString& step);
  /// After a division that came to nothing: on with the one before, unless the case says otherwise by now (undone).
  void goOnOrForget();
  void follow();
  void become(State state);

  JobRunner& jobs_;
  Document& document_;
  State state_ = State::None;
  JobId trees_ = 0;        ///< the job that makes the vessels' trees
  JobId division_ = 0;     ///< the newest job that divides the liver
  bool dividing_ = false;  ///< it runs: what is known is of an older choice
  std::shared_ptr<const LiverPerfusion> perfusion_;
  TerritoryChoice choice_;
  TerritoryChoice wanted_;  ///< of the division that runs; else choice_
  TerritoryMarks divided_;  ///< what the case says where territories_ are shown
  std::shared_ptr<const Territories> territories_;
  std::vector<TumourTerritories> tumours_;  ///< where they lie in territories_
  std::optional<TerritoryReport> report_;
  ResectionPlan reported_;  ///< what report_ is of
};

}  // namespace glisson
