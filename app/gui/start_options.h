#pragma once
// Purpose: the command line of glisson (design.md section 4): what to open and whether to make a picture of it.

#include <QSize>
#include <QString>
#include <QStringList>

#include "reconstruction/io/read.h"

namespace glisson {

struct StartOptions {
  QStringList paths;
  bool sample = false;
  QString screenshot;     ///< path of a PNG; both empty: an ordinary window
  QString pdf;            ///< path of a report
  QString plan;           ///< name of the plan that picture and report are of; empty: the first
  bool identity = false;  ///< the report names the patient
  QSize size{1440, 900};
  QString language;  ///< "en", "de" or empty: the remembered one
  ReadOptions read;
  bool help = false;
  bool version = false;
};

/// Parses the arguments without the program's name. Throws UsageError: one sentence.
StartOptions parseStartOptions(const QStringList& arguments);
/// The text of --help.
QString usageText();

}  // namespace glisson
