#pragma once
// Purpose: pictures that tests make, kept for the eye in the folder GLISSON_TEST_PICTURES where it is set.

#include <QImage>
#include <QString>

namespace glisson::test {

/// `image`, after it was written to NAME.png.
inline QImage kept(const QImage& image, const QString& name) {
  if (const QByteArray folder = qgetenv("GLISSON_TEST_PICTURES"); !folder.isEmpty()) {
    image.save(QString::fromUtf8(folder) + "/" + name + ".png");
  }
  return image;
}

}  // namespace glisson::test
