#include "gui/service/SaveImage.h"

#include <QBuffer>
#include <QByteArray>

#include "core/Error.h"
#include "core/FileName.h"
#include "core/ReplaceFile.h"

namespace velum::gui {

void saveImage(const QImage& image, const std::filesystem::path& path) {
  std::string format = lowerExtension(path);
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  // To memory: Qt's files do not say that the disk was full when they are closed.
  if (!image.save(&buffer, format.empty() ? "PNG" : format.c_str() + 1))
    throw InputError(path.string() + ": pictures of the window are written as .png, .jpg or .bmp");
  replaceFile(path, std::string_view(bytes.constData(), std::size_t(bytes.size())));
}

}  // namespace velum::gui
