#include "app/gui/lab_side.h"

#include <utility>

#include "reconstruction/evaluation/model_mesh.h"

namespace glisson {

namespace {
/// Most models of the slider are there before: a notice that comes and goes would take the time that they need.
constexpr int kLateMs = 300;
/// A deeper PSR model, or one of another family, takes long enough to be seen among the jobs.
constexpr int kDeepestQuick = 8;
}  // namespace

struct LabSide::Made {
  EvaluatedModel model;
  std::shared_ptr<const Reconstruction> reconstruction;
  std::shared_ptr<const DisplayMesh> mesh;
};

LabSide::LabSide(JobRunner& jobs, QString letter, QObject* parent) : QObject(parent), jobs_(jobs), letter_(std::move(letter)) {
  late_.setSingleShot(true);
  late_.setInterval(kLateMs);
  connect(&late_, &QTimer::timeout, this, &LabSide::changed);
  connect(&jobs_, &JobRunner::jobEnded, this, [this](JobId id, JobState state) {
    if (id == running_[0] && state != JobState::Done) {
      showNothing();  // so that it can be asked for again
      emit changed();
    } else if (state != JobState::Done && (id == running_[1] || id == running_[2])) {
      running_[id == running_[1] ? 1 : 2] = 0;
      emit changed();
    }
  });
}

void LabSide::setSubject(std::shared_ptr<const lab::LabSubject> subject, const ExperimentOptions& options) {
  for (JobId& job : running_) {
    jobs_.cancel(std::exchange(job, 0));
  }
  subject_ = std::move(subject);
  options_ = options;
  showNothing();
  emit changed();
}

void LabSide::showNothing() {
  recipe_.reset();
  surface_ = {};
  reconstruction_.reset();
  p95Mm_.reset();
  model_.reset();
  pending_ = false;
  late_.stop();
}

JobRequest LabSide::request(const char* stage, const QString& title) {
  const QString name = letter_ + QStringLiteral(": ") + QString::fromStdString(modelName(*recipe_));
  JobRequest request{.key = QStringLiteral("lab/%1/%2").arg(QLatin1String(stage), letter_), .title = title.arg(name)};
  request.fail = [this](const std::exception& error) { emit failed(messageOf(error)); };
  return request;
}

void LabSide::show(const ModelRecipe& recipe, bool measured) {
  if (subject_ == nullptr || recipe_ == recipe) {
    return;
  }
  recipe_ = recipe;
  pending_ = true;
  for (JobId& job : running_) {
    jobs_.cancel(std::exchange(job, 0));
  }
  JobRequest making = request("surface", QStringLiteral("%1"));
  making.quiet = recipe.family == ModelFamily::Psr && recipe.depth <= kDeepestQuick;
  running_[0] = submitFor<Made>(
      jobs_, std::move(making),
      [subject = subject_, options = options_, recipe](const ExecutionContext& context) {
        return make(*subject, recipe, options, context);
      },
      [this, measured](const Made& made) { take(made, measured); });
  late_.start();
}

LabSide::Made LabSide::make(const lab::LabSubject& subject, const ModelRecipe& recipe, const ExperimentOptions& options,
                            const ExecutionContext& context) {
  ModelMesh mesh;
  if (recipe.family == ModelFamily::Psr || recipe.family == ModelFamily::SimplifiedPsr) {
    const lab::LabSamples& samples = subject.samples(options.sampling, context);
    mesh = makeModelMesh(samples.points, subject.geometry(), recipe, options, context);
    mesh.seconds.sample += samples.seconds;  // the time of PSR holds that of the points, whoever took them
  } else {
    mesh = makeModelMesh(subject.mask(), subject.geometry(), recipe, options, context);
  }
  auto reconstruction = std::make_shared<Reconstruction>();
  reconstruction->mesh = std::move(mesh.mesh);
  Made made;
  made.model.recipe = recipe;
  made.model.usedDepth = mesh.usedDepth;
  made.model.seconds = mesh.seconds;
  made.reconstruction = std::move(reconstruction);
  made.mesh = makeBareDisplayMesh(made.reconstruction);
  return made;
}

void LabSide::take(const Made& made, bool measured) {
  pending_ = false;
  late_.stop();
  model_ = made.model;
  reconstruction_ = made.reconstruction;
  surface_ = {made.mesh, nullptr};
  p95Mm_.reset();
  colour();
  if (!measured) {
    measure();
  }
  emit changed();
}

void LabSide::colour() {
  struct Coloured {
    ShownSurface surface;
    double p95Mm = 0;
  };
  running_[1] = submitFor<Coloured>(
      jobs_, request("colours", tr("%1, distances")),
      [subject = subject_, mesh = surface_.mesh](const ExecutionContext& context) {
        const EvaluationReference& reference = subject->reference(context);
        Coloured made;
        made.surface.mesh = withStandIns(*mesh);
        std::optional<double> p95;  // of the surface's own vertices, which come first
        made.surface.errors = makeSurfaceErrors(*made.surface.mesh, [&](std::span<const Vec3> points) {
          std::vector<double> distances = reference.distancesToVoxels(points, context);
          if (!p95) {
            p95 = summarise(distances).p95;
          }
          return distances;
        });
        made.p95Mm = *p95;
        return made;
      },
      [this](const Coloured& made) {
        running_[1] = 0;
        surface_ = made.surface;
        p95Mm_ = made.p95Mm;
        emit changed();
      });
}

void LabSide::measure() {
  running_[2] = submitFor<ModelMeasures>(
      jobs_, request("numbers", tr("%1, numbers")),
      [subject = subject_, recipe = *recipe_, reconstruction = reconstruction_](const ExecutionContext& context) {
        const EvaluationReference& reference = subject->reference(context.range(0.0, 0.3));
        return measureModel(reconstruction->mesh, recipe, reference, context.range(0.3, 1.0));
      },
      [this](const ModelMeasures& measures) {
        model_->measures = measures;
        running_[2] = 0;
        emit changed();
      });
}

}  // namespace glisson
