#include "gui/service/Thumbnail.h"

#include <QBuffer>
#include <QCryptographicHash>
#include <QDateTime>
#include <QFileInfo>
#include <QUrl>
#include <system_error>

#include "core/Error.h"
#include "core/FileName.h"
#include "core/ReplaceFile.h"
#include "session/document/Folders.h"

namespace velum::gui {

namespace fs = std::filesystem;

namespace {

constexpr int kThumbnailSizes[] = {128, 256};

QByteArray addressOf(const fs::path& file) {
  return QUrl::fromLocalFile(QString::fromStdString(file.string())).toEncoded(QUrl::FullyEncoded);
}

/// The standard wants thumbnails to be for their owner alone.
void makePrivateFolder(const fs::path& folder) {
  std::error_code error;
  if (fs::create_directories(folder, error)) fs::permissions(folder, fs::perms::owner_all, error);
}

}  // namespace

fs::path thumbnailOf(const fs::path& file, int size) {
  QByteArray sum = QCryptographicHash::hash(addressOf(file), QCryptographicHash::Md5).toHex();
  return session::cacheFolder().parent_path() / "thumbnails" / (size > 128 ? "large" : "normal") /
         (sum.toStdString() + ".png");
}

void keepThumbnail(const fs::path& file, const QImage& image) {
  QFileInfo info(QString::fromStdString(file.string()));
  if (image.isNull() || lowerExtension(file) != ".json" || !info.exists()) return;
  for (int size : kThumbnailSizes) {
    QImage small =
        image.convertToFormat(QImage::Format_RGB32).scaled(size, size, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    small.setText("Thumb::URI", QString::fromLatin1(addressOf(file)));
    small.setText("Thumb::MTime", QString::number(info.lastModified().toSecsSinceEpoch()));
    small.setText("Software", "Velum");
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    if (!small.save(&buffer, "PNG")) return;
    fs::path path = thumbnailOf(file, size);
    makePrivateFolder(path.parent_path().parent_path());
    makePrivateFolder(path.parent_path());
    try {
      replaceFile(path, std::string_view(bytes.constData(), std::size_t(bytes.size())), ReplaceFile::Access::Owner);
    } catch (const Error&) {
      return;  // a file without a picture is no loss
    }
  }
}

}  // namespace velum::gui
