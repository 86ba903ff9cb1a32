#include "app/gui/territory_estimator.h"

#include <algorithm>

#include "planning/territories/marked_branches.h"
#include "planning/territories/segment_map.h"
#include "reconstruction/errors.h"

namespace glisson {

namespace {

constexpr const char* kPropose = QT_TRANSLATE_NOOP("glisson::Document", "propose territories");
constexpr const char* kConfirm = QT_TRANSLATE_NOOP("glisson::Document", "confirm territories");
constexpr const char* kSegments = QT_TRANSLATE_NOOP("glisson::Document", "choose map of segments");
constexpr const char* kPick = QT_TRANSLATE_NOOP("glisson::Document", "pick territory");

/// The first "Territory N" that is free.
std::string freeName(const std::vector<TerritoryPick>& picks) {
  for (std::size_t n = picks.size() + 1;; ++n) {
    std::string name = "Territory " + std::to_string(n);
    if (std::ranges::none_of(picks, [&](const TerritoryPick& pick) { return pick.name == name; })) {
      return name;
    }
  }
}

/// The liver as `choice` divides it; a new map of segments, one with options, gets its fingerprint. Where one that the case keeps
/// cannot be had any more, `choice` becomes the proposal.
Territories divided(const Case& content, const VesselGraph& portal, TerritoryChoice& choice,
                    const std::optional<ReadOptions>& newMap, const ExecutionContext& context) {
  if (newMap) {
    Territories read = segmentTerritories(content, choice.segments->path, *newMap, context);
    choice.segments = segmentMapFile(choice.segments->path, read);
    return read;
  }
  try {
    return territoriesOf(content, portal, choice, context);
  } catch (const InputError& gone) {
    if (!choice.segments) {
      throw;
    }
    choice = proposeLeftRight(portal);
    choice.notes.emplace_back(gone.what());
  }
  return territoriesOf(content, portal, choice, context);
}

}  // namespace

TerritoryEstimator::TerritoryEstimator(JobRunner& jobs, Document& document, QObject* parent)
    : QObject(parent), jobs_(jobs), document_(document) {
  connect(&document_, &Document::caseChanged, this, &TerritoryEstimator::forget);
  connect(&document_, &Document::planChanged, this, [this] {
    if (state_ == State::Current && !(document_.plan() == reported_)) {
      become(State::Following);
    }
  });
  connect(&document_, &Document::territoriesChanged, this, [this] {
    if (perfusion_ && !(divided_ == document_.content().territories)) {  // undone, or done again
      divide(choiceOf(document_.content().territories, perfusion_->portal()));
    }
  });
  // A drag moves the plane often; the estimates follow when it rests.
  connect(&document_, &Document::assessmentChanged, this, [this] {
    if (state_ == State::Following && !dividing_ && !document_.isDragging() && document_.freshness() == Freshness::All) {
      follow();
    }
  });
  connect(&jobs_, &JobRunner::jobEnded, this, [this](JobId ended, JobState how) {
    if (ended == trees_ && how == JobState::Cancelled && state_ == State::Computing) {
      become(State::None);
    } else if (ended == division_ && how == JobState::Cancelled) {
      goOnOrForget();
    }
  });
}

void TerritoryEstimator::become(State state) {
  state_ = state;
  emit changed();
}

void TerritoryEstimator::forget() {
  perfusion_.reset();
  choice_ = wanted_ = {};
  divided_ = {};
  division_ = 0;
  dividing_ = false;
  territories_.reset();
  tumours_.clear();
  report_.reset();
  become(State::None);
}

void TerritoryEstimator::estimate() {
  if (!document_.isOpen() || state_ != State::None) {
    return;
  }
  using Perfusion = std::shared_ptr<const LiverPerfusion>;
  JobRequest request{.key = "vesselTrees", .title = tr("Territories"), .heavy = true};
  request.fail = [this](const std::exception& error) {
    become(State::None);
    emit refused(messageOf(error));
  };
  become(State::Computing);
  trees_ = submitFor<Perfusion>(
      jobs_, std::move(request),
      [content = document_.content()](const ExecutionContext& context) {
        return std::make_shared<const LiverPerfusion>(content, context);
      },
      [this, code = document_.content().code](const Perfusion& perfusion) {
        if (document_.content().code == code && state_ == State::Computing) {
          perfusion_ = perfusion;
          divide(choiceOf(document_.content().territories, perfusion_->portal()));
        }
      });
}

void TerritoryEstimator::propose() {
  if (perfusion_) {
    divide(proposeLeftRight(perfusion_->portal()), QString::fromLatin1(kPropose));
  }
}

void TerritoryEstimator::chooseSegments(const QString& path, const ReadOptions& options) {
  if (perfusion_) {
    divide(segmentChoice({path.toStdString(), {}}), QString::fromLatin1(kSegments), options);
  }
}

void TerritoryEstimator::confirm() {
  if (!wanted_.picks.empty() && !wanted_.confirmed) {
    TerritoryChoice confirmed = wanted_;
    confirmed.confirmed = true;
    divide(std::move(confirmed), QString::fromLatin1(kConfirm));
  }
}

void TerritoryEstimator::pick(const Vec3& pointMm) {
  if (!perfusion_) {
    return;
  }
  const std::optional<std::int32_t> branch = nearestSupplyingBranch(perfusion_->portal(), pointMm);
  if (!branch) {
    emit refused(QStringLiteral("No branch of the portal vein supplies the liver here."));
    return;
  }
  TerritoryChoice picked;
  picked.confirmed = true;  // the user points at it
  if (wanted_.source == TerritorySource::Picked) {
    picked.picks = wanted_.picks;
  }
  picked.picks.push_back({freeName(picked.picks), {*branch}});
  divide(std::move(picked), QString::fromLatin1(kPick));
}

void TerritoryEstimator::keep(const QString& step) {
  divided_ = step.isEmpty() ? document_.content().territories : marksOf(choice_, perfusion_->portal());
  if (!step.isEmpty()) {
    document_.setTerritories(divided_, step);
  }
}

void TerritoryEstimator::divide(TerritoryChoice choice, const QString& step, const std::optional<ReadOptions>& newMap) {
  wanted_ = choice;
  if (choice.picks.empty() && !choice.segments) {
    dividing_ = false;
    choice_ = std::move(choice);
    territories_ = std::make_shared<const Territories>(territoriesOf(document_.content(), perfusion_->portal(), choice_));
    tumours_.clear();
    keep(step);
    follow();
    return;
  }
  struct Parts {
    TerritoryChoice choice;
    std::shared_ptr<const Territories> territories;
    std::vector<TumourTerritories> tumours;
  };
  JobRequest request{.key = "territories", .title = tr("Territories")};
  request.fail = [this, perfusion = perfusion_, newMap, segments = choice.segments](const std::exception& error) {
    if (perfusion_ != perfusion) {
      return;  // it is of a case that was closed
    }
    goOnOrForget();
    if (newMap) {
      emit mapRefused(QString::fromStdString(segments->path), *newMap, messageOf(error));
    } else {
      emit refused(messageOf(error));
    }
  };
  dividing_ = true;
  become(State::Following);
  division_ = 0;  // that a newer division takes the place of this one is no end
  division_ = submitFor<Parts>(
      jobs_, std::move(request),
      [content = document_.content(), perfusion = perfusion_, choice, newMap](const ExecutionContext& context) {
        Parts parts;
        parts.choice = choice;
        parts.territories =
            std::make_shared<const Territories>(divided(content, perfusion->portal(), parts.choice, newMap, context));
        parts.tumours = tumourTerritories(content, *parts.territories);
        return parts;
      },
      [this, perfusion = perfusion_, step, asked = document_.content().territories](Parts parts) {
        if (perfusion_ == perfusion && !(document_.content().territories == asked)) {  // undone meanwhile
          divide(choiceOf(document_.content().territories, perfusion_->portal()));
        } else if (perfusion_ == perfusion) {
          dividing_ = false;
          choice_ = wanted_ = std::move(parts.choice);
          territories_ = std::move(parts.territories);
          tumours_ = std::move(parts.tumours);
          keep(step);
          follow();
        }
      });
}

void TerritoryEstimator::goOnOrForget() {
  dividing_ = false;
  wanted_ = choice_;
  if (perfusion_ && territories_ && divided_ == document_.content().territories) {
    follow();
  } else {
    forget();
  }
}

void TerritoryEstimator::follow() {
  if (!perfusion_ || !territories_) {
    return;
  }
  become(State::Following);
  JobRequest request{.key = "territoryNumbers", .quiet = true};
  request.fail = [this](const std::exception& error) { emit refused(messageOf(error)); };
  submitFor<TerritoryReport>(
      jobs_, std::move(request),
      [perfusion = perfusion_, territories = territories_, tumours = tumours_, plan = document_.plan()](const ExecutionContext&) {
        TerritoryReport report{*territories, volumesOf(*territories, plan), perfusion->effectOf(plan), perfusion->notes(), tumours};
        report.notes.insert(report.notes.end(), territories->notes.begin(), territories->notes.end());
        return report;
      },
      [this, territories = territories_, plan = document_.plan()](TerritoryReport report) {
        if (!dividing_ && territories_ == territories && document_.plan() == plan) {
          report_ = std::move(report);
          reported_ = plan;
          become(State::Current);
        }
      });
}

}  // namespace glisson
