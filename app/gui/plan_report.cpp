#include "app/gui/plan_report.h"

#include <Eigen/Geometry>
#include <QAbstractTextDocumentLayout>
#include <QCoreApplication>
#include <QLocale>
#include <QPainter>
#include <QPdfWriter>
#include <QSaveFile>
#include <QTextDocument>

#include "app/gui/acceptance_box.h"
#include "app/gui/model_builder.h"
#include "app/gui/number_text.h"
#include "app/gui/plan_panel.h"
#include "app/gui/sentences.h"
#include "app/gui/territory_box.h"
#include "planning/exchange/version.h"
#include "planning/report/flr_card.h"
#include "planning/storage/sha256.h"
#include "planning/volumetry/tumour_measures.h"
#include "reconstruction/errors.h"
#include "viewer/model_view.h"

namespace glisson {

namespace {

constexpr int kDotsPerInch = 150;
constexpr double kMarginMm = 15;
constexpr int kFooterMm = 12;

/// lupdate files what stands in tr() outside of classes under the namespace.
QString tr(const char* text) { return QCoreApplication::translate("glisson", text); }

QString cell(const QString& text, bool number = false) {
  return QStringLiteral("<td%1>%2</td>").arg(number ? QStringLiteral(" align=\"right\"") : QString(), text.toHtmlEscaped());
}

QString row(const QStringList& cells, int numbersFrom = 1) {
  QString html = QStringLiteral("<tr>");
  for (int n = 0; n < cells.size(); ++n) {
    html += cell(cells[n], n >= numbersFrom);
  }
  return html + QStringLiteral("</tr>");
}

QString header(const QStringList& cells) {
  QString html = QStringLiteral("<tr>");
  for (int n = 0; n < cells.size(); ++n) {
    html += QStringLiteral("<th align=\"%1\">%2</th>").arg(n == 0 ? "left" : "right", cells[n].toHtmlEscaped());
  }
  return html + QStringLiteral("</tr>");
}

QString table(const QString& rows) {
  return QStringLiteral("<table width=\"100%\" cellspacing=\"0\" cellpadding=\"2\" border=\"0\">") + rows +
         QStringLiteral("</table>");
}

QString heading(const QString& text) { return QStringLiteral("<h3>") + text.toHtmlEscaped() + QStringLiteral("</h3>"); }

QString paragraph(const QString& text) { return QStringLiteral("<p>") + text.toHtmlEscaped() + QStringLiteral("</p>"); }

QString patientLine(const PlanReport& report) {
  const PatientIdentity& patient = report.content.identity;
  QStringList parts{QString::fromStdString(report.content.code)};
  if (report.withIdentity) {
    QString name = QString::fromStdString(patient.patientName);
    name.replace('^', QStringLiteral(", "));
    const QString id = QString::fromStdString(patient.patientId);
    const QString born = dateText(patient.birthDate);
    parts << name << (id.isEmpty() ? id : tr("id %1").arg(id)) << (born.isEmpty() ? born : tr("born %1").arg(born));
  }
  parts << tr("CT of %1").arg(dateText(patient.studyDate)) << QString::fromStdString(patient.seriesDescription);
  parts.removeAll(QString());
  return parts.join(QStringLiteral(" \u00B7 "));
}

QString numbersOf(const PlanReport& report) {
  const PlanAssessment& a = report.assessment;
  if (!a.divides) {
    return paragraph(shownSentence(a.warning));
  }
  const QString uncertainty = QStringLiteral(" \u00B1\u00A0") + mlText(a.volumeUncertaintyMl, 1);
  const auto percent = [](double part, double whole) { return whole > 0 ? percentText(100 * part / whole, 1) : QString(); };
  QString rows = header({tr("Volume"), tr("value"), tr("share")});
  rows += row({tr("Liver, tumours in it included"), mlText(a.totalMl, 1), {}});
  rows += row({tr("Functional liver"), mlText(a.functionalMl, 1), percent(a.functionalMl, a.totalMl)});
  rows += row({tr("Resected"), mlText(a.resectedMl, 1) + uncertainty, percent(a.resectedMl, a.totalMl)});
  rows += row({tr("Remnant"), mlText(a.remnantMl, 1) + uncertainty, percent(a.remnantMl, a.totalMl)});
  rows += row({tr("Functional remnant (FLR), share of the functional liver"), mlText(a.functionalRemnantMl, 1) + uncertainty,
               percentText(a.flrPercent, 1)});
  QString html = table(rows);
  if (!a.warning.empty()) {
    html += paragraph(shownSentence(a.warning));
  }
  return html;
}

/// What matters before any margin: tumours that are cut or stay behind; empty where all are removed.
QString untreatedOf(const PlanAssessment& assessment) {
  const auto sentence = [&](TumourState state, const QString& text) {
    QStringList names;
    for (const TumourAssessment& tumour : assessment.tumours) {
      if (tumour.state == state) {
        names << shownName(tumour.name);
      }
    }
    const QString number = tr("%1 of %2").arg(names.size()).arg(assessment.tumours.size());
    return names.isEmpty() ? QString() : paragraph(text.arg(number, names.join(QStringLiteral(", "))));
  };
  return sentence(TumourState::Cut, tr("Tumours cut: %1 (%2).")) + sentence(TumourState::Left, tr("Tumours left behind: %1 (%2)."));
}

QString tumoursOf(const PlanReport& report) {
  const std::vector<TumourMeasures> measured = tumourMeasures(report.content);
  QString rows = header({tr("Tumour"), tr("volume"), tr("longest diameter"), tr("to the capsule"), tr("nearest vessel"),
                         tr("state"), tr("margin"), tr("at least")});
  for (const TumourAssessment& tumour : report.assessment.tumours) {
    QString volume;
    QString diameter;
    QString capsule;
    QString vessel;
    for (const TumourMeasures& m : measured) {
      if (m.id == tumour.id) {
        volume = mlText(m.volumeMl, 1);
        diameter = mmText(m.longestDiameterMm);
        capsule = mmText(m.capsuleMm);
        vessel = m.vesselMm ? shownName(m.nearestVessel) + QStringLiteral(", ") + mmText(*m.vesselMm) : QString();
      }
    }
    const QString margin = tumour.marginMm     ? mmText(*tumour.marginMm)
                           : tumour.distanceMm ? tr("%1 from the cut").arg(mmText(*tumour.distanceMm))
                                               : QString();
    rows += row({shownName(tumour.name), volume, diameter, capsule, vessel, stateText(tumour.state), margin,
                 tumour.marginAtLeastMm ? mmText(*tumour.marginAtLeastMm) : QString()});
  }
  return heading(tr("Tumours (safety margin %1)").arg(mmText(report.plan.safetyMarginMm))) + untreatedOf(report.assessment) +
         table(rows);
}

QString vesselsOf(const PlanReport& report) {
  if (!report.assessment.divides) {
    return {};
  }
  QString rows = header({tr("Vessel crossed"), tr("diameter"), QStringLiteral("L"), QStringLiteral("P"), QStringLiteral("S")});
  for (const VesselCrossing& vessel : report.assessment.vesselsCrossed) {
    rows += row({shownName(vessel.name), mmText(vessel.diameterMm), numberText(vessel.positionMm.x(), 1),
                 numberText(vessel.positionMm.y(), 1), numberText(vessel.positionMm.z(), 1)});
  }
  return heading(tr("Vessels crossed: %1").arg(report.assessment.vesselsCrossed.size())) + table(rows);
}

QString cardOf(const PlanReport& report) {
  const FlrCard card = flrCard(report.content.patient, report.assessment);
  const auto ratioName = [](FlrRatioKind kind) {
    switch (kind) {
      case FlrRatioKind::OfFunctionalPercent:
        return tr("FLR of the functional liver");
      case FlrRatioKind::OfSlvUrataPercent:
        return tr("FLR of the standardised volume (Urata)");
      case FlrRatioKind::OfSlvVautheyPercent:
        return tr("FLR of the standardised volume (Vauthey)");
      case FlrRatioKind::PerBsaMlPerM2:
        return tr("FLR per body surface, mL/m\u00B2");
      case FlrRatioKind::PerBodyWeightPercent:
        break;
    }
    return tr("FLR of the body weight");
  };
  const auto valueText = [](FlrRatioKind kind, double value, int decimals) {
    return kind == FlrRatioKind::PerBsaMlPerM2 ? numberText(value, 0) : percentText(value, decimals);
  };
  QString rows = header({tr("Ratio"), tr("value"), tr("published")});
  for (const FlrRatio& ratio : card.ratios) {
    QStringList published;
    for (const FlrThreshold& threshold : ratio.thresholds) {
      published << QString::fromStdString(std::string(threshold.citation)) + QStringLiteral(": ") +
                       valueText(ratio.kind, threshold.value, 1);
    }
    rows += row({ratioName(ratio.kind), valueText(ratio.kind, ratio.value, 2), published.join(QStringLiteral("; "))});
  }
  QString html = heading(tr("FLR card: published numbers for information, not advice")) + table(rows);
  for (const std::string& reason : card.reasons) {
    html += paragraph(shownSentence(reason));
  }
  return html;
}

QString territoriesOf(const PlanReport& report) {
  if (!report.territories) {
    return {};
  }
  QString html = heading(tr("Territories and the remnant's blood: estimates"));
  if (!report.territories->volumes.empty()) {
    QString rows = header({tr("Territory"), tr("volume"), tr("resected"), tr("remnant")});
    for (const TerritoryVolume& part : report.territories->volumes) {
      rows += row({territoryName(part.name), mlText(part.volumeMl, 1), mlText(part.resectedMl, 1), mlText(part.remnantMl, 1)});
    }
    html += table(rows);
    if (!report.territories->territories.confirmed) {
      html += paragraph(tr("Left and right are proposed from the main bifurcation; nobody has confirmed them."));
    }
  }
  html += paragraph(perfusionText(report.territories->effect));
  for (const std::string& note : report.territories->notes) {
    html += paragraph(shownSentence(note));
  }
  return html;
}

QString vectorText(const Vec3& v, int decimals) {
  return QStringLiteral("%1  %2  %3").arg(numberText(v.x(), decimals), numberText(v.y(), decimals), numberText(v.z(), decimals));
}

/// All that a bent plane is, beyond its point and normal.
QString bendText(const QString& name, const ResectionPlane& plane) {
  const Bend& bend = *plane.bend;
  QStringList heights;
  for (const double height : bend.heightsMm) {
    heights << numberText(height, 1);
  }
  return tr("%1 is bent: a cubic Bezier surface over a square of %2 mm around its point, u along %3, v = normal x u along %4. "
            "Control points, mm above the plane, from -u and -v on, u running fastest: %5. Beyond the square the heights go on as "
            "they are at its border.")
      .arg(name, numberText(2 * bend.halfSizeMm, 0), vectorText(bend.u, 4), vectorText(plane.normal.cross(bend.u), 4),
           heights.join(QStringLiteral("; ")));
}

QString planesOf(const PlanReport& report) {
  QString rows = header({tr("Plane"), tr("a point of it, mm LPS"), tr("normal, to the resected side")});
  QString bends;
  for (const Resection& resection : report.plan.resections) {
    for (std::size_t n = 0; n < resection.planes.size(); ++n) {
      rows += row({shownName(resection.name) + QStringLiteral(", ") + QString::number(n + 1),
                   vectorText(resection.planes[n].origin, 1), vectorText(resection.planes[n].normal, 4)});
      if (resection.planes[n].bend) {
        bends +=
            paragraph(bendText(shownName(resection.name) + QStringLiteral(", ") + QString::number(n + 1), resection.planes[n]));
      }
    }
  }
  QString html = heading(tr("Planes")) + table(rows) + bends;
  if (!report.plan.measures.empty()) {
    QString distances;
    for (const Measure& measure : report.plan.measures) {
      distances += row({shownName(measure.name), mmText(measure.mm())});
    }
    html += heading(tr("Measured distances")) + table(distances);
  }
  return html;
}

QString meshHash(const SurfaceMesh& mesh) {
  Sha256 sum;
  sum.update(std::as_bytes(std::span(mesh.vertices)));
  sum.update(std::as_bytes(std::span(mesh.triangles)));
  return QString::fromStdString(sum.hex());
}

QString structuresOf(const PlanReport& report) {
  QString rows = header({tr("Structure"), tr("made by"), tr("triangles"), tr("voxels, mL"), tr("surface, mL"), tr("accepted by")});
  QString hashes;
  for (const Structure& structure : report.content.model->structures) {
    if (!structure.reconstruction) {
      rows += row({shownName(structure.name), tr("no surface yet"), {}, {}, {}, {}});
      continue;
    }
    const Reconstruction& made = *structure.reconstruction;
    rows += row({shownName(structure.name), shownSentence(made.parameters.describe()),
                 QLocale().toString(static_cast<qulonglong>(made.mesh.triangles.size())), numberText(made.voxelVolumeMl, 1),
                 numberText(made.meshVolumeMl, 1), acceptanceCell(structure)});
    hashes += row({shownName(structure.name), meshHash(made.mesh)});
  }
  return heading(tr("Structures and parameters")) + table(rows) + heading(tr("SHA-256 of the surfaces' vertices and triangles")) +
         QStringLiteral("<div style=\"font-family:'DejaVu Sans Mono'; font-size:6pt\">") + table(hashes) + QStringLiteral("</div>");
}

/// What nobody has looked at, on the first page.
QString notAcceptedOf(const PlanReport& report) {
  QStringList names;
  for (const Structure& structure : report.content.model->structures) {
    if (!structure.acceptance) {
      names << structureName(structure);
    }
  }
  return names.isEmpty() ? QString() : paragraph(tr("Not accepted by anybody: %1.").arg(names.join(QStringLiteral(", "))));
}

QString bodyOf(const PlanReport& report) {
  QString html = QStringLiteral("<h2>") + tr("Resection plan: %1").arg(shownName(report.plan.name)).toHtmlEscaped() +
                 QStringLiteral("</h2>") + paragraph(patientLine(report));
  html += QStringLiteral("<table width=\"100%\"><tr>");
  const std::array names{tr("from anterior"), tr("from superior"), tr("from the left")};
  for (std::size_t n = 0; n < names.size(); ++n) {
    html +=
        QStringLiteral("<td align=\"center\"><img src=\"view%1\" width=\"212\"><br>%2</td>").arg(n).arg(names[n].toHtmlEscaped());
  }
  html += QStringLiteral("</tr></table>") + numbersOf(report) + tumoursOf(report) + notAcceptedOf(report);
  html +=
      paragraph(tr("Pre-operative, supine, rigid: pneumoperitoneum and mobilisation move the liver by centimetres; registration "
                   "error not included. Not for clinical use."));
  html += QStringLiteral("<div style=\"page-break-before:always\"></div>") + vesselsOf(report) + cardOf(report) +
          territoriesOf(report) + planesOf(report) + structuresOf(report);
  return html;
}

void drawPages(QPdfWriter& writer, QTextDocument& document, const QString& footer) {
  QPainter painter(&writer);
  const double perMm = kDotsPerInch / 25.4;
  const QSizeF page(writer.width(), writer.height() - kFooterMm * perMm);
  document.setPageSize(page);
  const int pages = document.pageCount();
  for (int n = 0; n < pages; ++n) {
    if (n > 0) {
      writer.newPage();
    }
    painter.save();
    painter.translate(0, -n * page.height());
    document.drawContents(&painter, QRectF(0, n * page.height(), page.width(), page.height()));
    painter.restore();
    painter.setFont(QFont(document.defaultFont().family(), 7));
    const QRectF line(0, page.height() + 3 * perMm, page.width(), (kFooterMm - 3) * perMm);
    painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter, footer);
    painter.drawText(line, Qt::AlignRight | Qt::AlignVCenter, tr("page %1 of %2").arg(n + 1).arg(pages));
  }
}

}  // namespace

bool hasIdentity(const Case& content) {
  const PatientIdentity& patient = content.identity;
  return !patient.patientName.empty() || !patient.patientId.empty() || !patient.birthDate.empty();
}

std::array<QImage, 3> reportViews(const Case& content, const ResectionPlan& plan,
                                  const std::shared_ptr<const TumourDistance>& tumours) {
  ModelView view;
  view.resize(660, 560);
  view.setModel(content.model);
  view.setTumours(tumours);
  view.setPlan(plan);
  view.setHandlesShown(false);
  std::array<QImage, 3> views;
  constexpr std::array kViews{ModelView::StandardView::Anterior, ModelView::StandardView::Superior, ModelView::StandardView::Left};
  for (std::size_t n = 0; n < views.size(); ++n) {
    view.setStandardView(kViews[n]);
    views[n] = view.picture();
  }
  return views;
}

void writePdf(const PlanReport& report, const QString& path) {
  if (report.withIdentity && !hasIdentity(report.content)) {
    throw PlanningError("The case holds neither name, id nor birth date of the patient; write the report without them.");
  }
  QSaveFile file(path);
  if (!file.open(QIODevice::WriteOnly)) {
    throw InputError(path.toStdString() + " cannot be written; check the folder.");
  }
  {
    QPdfWriter writer(&file);
    writer.setResolution(kDotsPerInch);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setPageMargins(QMarginsF(kMarginMm, kMarginMm, kMarginMm, kMarginMm), QPageLayout::Millimeter);
    writer.setTitle(QString::fromStdString(report.content.code));
    writer.setCreator(QStringLiteral("Glisson ") + QString::fromStdString(std::string(glissonVersion())));
    QTextDocument document;
    document.documentLayout()->setPaintDevice(&writer);
    document.setDefaultFont(QFont(QStringLiteral("DejaVu Sans"), 8));
    for (std::size_t n = 0; n < report.views.size(); ++n) {
      document.addResource(QTextDocument::ImageResource, QUrl(QStringLiteral("view%1").arg(n)), report.views[n]);
    }
    document.setHtml(bodyOf(report));
    const QString footer =
        QStringList{QString::fromStdString(report.content.code), tr("CT of %1").arg(dateText(report.content.identity.studyDate)),
                    QStringLiteral("Glisson ") + QString::fromStdString(std::string(glissonVersion())), tr("not for clinical use")}
            .join(QStringLiteral(" \u00B7 "));
    drawPages(writer, document, footer);
  }
  if (!file.commit()) {
    throw InputError(path.toStdString() + " cannot be written; check the folder.");
  }
}

}  // namespace glisson
