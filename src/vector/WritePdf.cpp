#include "vector/WritePdf.h"

#include <fmt/format.h>
#define POINTERHOLDER_TRANSITION 4  // qpdf then has std::shared_ptr alone

#include <qpdf/QPDF.hh>
#include <qpdf/QPDFEFStreamObjectHelper.hh>
#include <qpdf/QPDFEmbeddedFileDocumentHelper.hh>
#include <qpdf/QPDFFileSpecObjectHelper.hh>
#include <qpdf/QPDFPageDocumentHelper.hh>
#include <qpdf/QPDFWriter.hh>

#include "core/Error.h"
#include "core/ImageChannels.h"
#include "core/ReplaceFile.h"
#include "vector/Bounds.h"
#include "vector/CairoPages.h"
#include "vector/Description.h"
#include "vector/Png.h"
#include "vector/Unicode.h"

namespace velum::vector {
namespace {

using Object = QPDFObjectHandle;

/// What one content stream draws: a plate, or else a page of Cairo.
struct Part {
  const Plate* plate = nullptr;
  std::size_t page = 0;
  std::string_view group;
};

/// A drawing on its way into a document. Cairo draws lines and letters, a page for what stands between two plates;
/// here these become forms on one page, each in its layer.
class PdfWriter {
 public:
  explicit PdfWriter(const Drawing& drawing);
  void attach(std::string_view description);
  std::string takeText();

 private:
  void plan();
  void addForms();
  void addLayers();
  /// An entry of the list of layers. @return its name in the content
  std::string addGroup(std::string_view name, bool isHidden, Object& order);
  std::string contentOf(const std::vector<Part>& parts, Object& order);
  Object imageOf(const Image& image);
  Object streamOf(const Image& image, Alpha alpha);
  std::string number(double pixels) const { return fmt::format("{:.4f}", pixels * mPoints); }
  /// Numbers of dictionaries.
  Object real(double pixels) const { return Object::newReal(pixels * mPoints, 4); }

  const Drawing& mDrawing;
  double mPoints;                         ///< 1/72 inch for a pixel
  std::vector<std::vector<Part>> mParts;  ///< of each layer
  std::vector<std::vector<const Item*>> mPages;
  std::vector<Object> mForms;  ///< of each page
  std::string mDrawnBytes;     ///< which mDrawn reads
  QPDF mDrawn, mPdf;
  Object mObjects = Object::newDictionary(), mGroups = Object::newDictionary();  ///< by names of the content
  Object mAll = Object::newArray(), mShown = Object::newArray(), mHidden = Object::newArray();
  std::string mContent;
};

PdfWriter::PdfWriter(const Drawing& drawing) : mDrawing(drawing), mPoints(72.0 / drawing.dpi) {
  mPdf.emptyPDF();
  plan();
  addForms();
  addLayers();
}

void PdfWriter::plan() {
  for (const Layer& layer : mDrawing.layers) {
    std::vector<Part>& parts = mParts.emplace_back();
    for (const Item& item : layer.items) {
      if (!isDrawable(item)) continue;
      if (auto* plate = std::get_if<Plate>(&item)) {
        parts.push_back({plate, 0, {}});
        continue;
      }
      if (parts.empty() || parts.back().plate || parts.back().group != groupOf(item)) {
        parts.push_back({nullptr, mPages.size(), groupOf(item)});
        mPages.emplace_back();
      }
      mPages.back().push_back(&item);
    }
  }
}

void PdfWriter::addForms() {
  if (mPages.empty()) return;
  mDrawnBytes = pagesOf(mPages, mDrawing.size, mPoints);
  mDrawn.processMemoryFile("drawing", mDrawnBytes.data(), mDrawnBytes.size());
  for (QPDFPageObjectHelper& page : QPDFPageDocumentHelper(mDrawn).getAllPages()) {
    Object form = mPdf.copyForeignObject(page.getFormXObjectForPage());
    // As if it stood on the page: programs that edit it would show a group in the layer.
    form.getDict().removeKey("/Group");
    mForms.push_back(form);
  }
}

Object PdfWriter::streamOf(const Image& image, Alpha alpha) {
  const bool isColor = alpha != Alpha::Alone;
  // Rows as in a PNG: what is predicted of them packs better.
  Object how = Object::newDictionary(), stream = Object::newStream(&mPdf), dictionary = stream.getDict();
  how.replaceKey("/Predictor", Object::newInteger(15));
  how.replaceKey("/Colors", Object::newInteger(isColor ? 3 : 1));
  how.replaceKey("/BitsPerComponent", Object::newInteger(8));
  how.replaceKey("/Columns", Object::newInteger(image.width));
  stream.replaceStreamData(packedRowsOf(pngOf(image, alpha)), Object::newName("/FlateDecode"), how);
  dictionary.replaceKey("/Type", Object::newName("/XObject"));
  dictionary.replaceKey("/Subtype", Object::newName("/Image"));
  dictionary.replaceKey("/Width", Object::newInteger(image.width));
  dictionary.replaceKey("/Height", Object::newInteger(image.height));
  dictionary.replaceKey("/ColorSpace", Object::newName(isColor ? "/DeviceRGB" : "/DeviceGray"));
  dictionary.replaceKey("/BitsPerComponent", Object::newInteger(8));
  return stream;
}

Object PdfWriter::imageOf(const Image& image) {
  Object stream = streamOf(image, Alpha::Without);
  if (channelIndex(image, "A") >= 0) stream.getDict().replaceKey("/SMask", streamOf(image, Alpha::Alone));
  return stream;
}

std::string PdfWriter::addGroup(std::string_view name, bool isHidden, Object& order) {
  Object group = Object::newDictionary();
  group.replaceKey("/Type", Object::newName("/OCG"));
  group.replaceKey("/Name", Object::newUnicodeString(cleanText(name)));
  group = mPdf.makeIndirectObject(group);
  std::string key = fmt::format("/L{}", mAll.getArrayNItems());
  mGroups.replaceKey(key, group);
  mAll.appendItem(group);
  order.appendItem(group);
  (isHidden ? mHidden : mShown).appendItem(group);
  return key;
}

/// @param order  gets the groups within the layer
std::string PdfWriter::contentOf(const std::vector<Part>& parts, Object& order) {
  std::string content;
  for (const Part& part : parts) {
    std::string name = fmt::format("/X{}", mObjects.getKeys().size());
    mObjects.replaceKey(name, part.plate ? imageOf(*part.plate->image) : mForms[part.page]);
    if (part.plate) {
      double bottom = mDrawing.size.y - part.plate->low.y - part.plate->size.y;
      content += fmt::format("q {} 0 0 {} {} {} cm {} Do Q\n", number(part.plate->size.x), number(part.plate->size.y),
                             number(part.plate->low.x), number(bottom), name);
    } else if (part.group.empty()) {
      content += fmt::format("q {} Do Q\n", name);
    } else {
      content += fmt::format("/OC {} BDC\nq {} Do Q\nEMC\n", addGroup(part.group, false, order), name);
    }
  }
  return content;
}

void PdfWriter::addLayers() {
  Object order = Object::newArray();
  for (std::size_t i = 0; i < mParts.size(); ++i) {
    const Layer& layer = mDrawing.layers[i];
    Object within = Object::newArray();
    std::string name = addGroup(layer.name, layer.isHidden, order);
    mContent += fmt::format("/OC {} BDC\n{}EMC\n", name, contentOf(mParts[i], within));
    if (within.getArrayNItems() > 0) order.appendItem(within);
  }
  Object shown = Object::newDictionary(), properties = Object::newDictionary();
  shown.replaceKey("/Order", order);
  shown.replaceKey("/ON", mShown);
  if (mHidden.getArrayNItems() > 0) shown.replaceKey("/OFF", mHidden);
  properties.replaceKey("/OCGs", mAll);
  properties.replaceKey("/D", shown);
  if (mAll.getArrayNItems() > 0) mPdf.getRoot().replaceKey("/OCProperties", properties);
}

void PdfWriter::attach(std::string_view description) {
  expectDescription(description);
  if (description.empty()) return;
  auto stream = QPDFEFStreamObjectHelper::createEFStream(mPdf, std::string(description));
  stream.setSubtype("application/json");
  stream.getObjectHandle().getDict().replaceKey(kPdfDescription, Object::newBool(true));
  auto file = QPDFFileSpecObjectHelper::createFileSpec(mPdf, "scene.json", stream);
  file.setDescription("The scene, for Velum");
  QPDFEmbeddedFileDocumentHelper(mPdf).replaceEmbeddedFile("scene.json", file);
}

std::string PdfWriter::takeText() {
  // The page, on which what is transparent is mixed in the colours that it is given in.
  Object page = Object::parse("<< /Type /Page /Group << /Type /Group /S /Transparency /CS /DeviceRGB /I true >> >>");
  Object resources = Object::newDictionary();
  resources.replaceKey("/XObject", mObjects);
  resources.replaceKey("/Properties", mGroups);
  page.replaceKey("/MediaBox", Object::newArray({Object::newInteger(0), Object::newInteger(0), real(mDrawing.size.x),
                                                 real(mDrawing.size.y)}));
  page.replaceKey("/Resources", resources);
  page.replaceKey("/Contents", Object::newStream(&mPdf, mContent));
  QPDFPageDocumentHelper(mPdf).addPage(QPDFPageObjectHelper(mPdf.makeIndirectObject(page)), false);

  Object information = Object::newDictionary();
  if (!mDrawing.title.empty()) information.replaceKey("/Title", Object::newUnicodeString(cleanText(mDrawing.title)));
  information.replaceKey("/Producer", Object::newString("Velum"));
  mPdf.getTrailer().replaceKey("/Info", mPdf.makeIndirectObject(information));
  mPdf.getRoot().replaceKey("/ViewerPreferences", Object::parse("<< /DisplayDocTitle true >>"));

  QPDFWriter writer(mPdf);
  writer.setOutputMemory();
  writer.setMinimumPDFVersion("1.5");
  writer.setDeterministicID(true);
  writer.write();
  auto bytes = writer.getBufferSharedPointer();
  return {reinterpret_cast<const char*>(bytes->getBuffer()), bytes->getSize()};
}

}  // namespace

std::string pdfOf(const Drawing& drawing, std::string_view description) {
  try {
    PdfWriter writer(drawing);
    writer.attach(description);
    return writer.takeText();
  } catch (const Error&) {
    throw;
  } catch (const std::exception& error) {
    throw Error(ExitCode::Input, std::string("the drawing cannot be written as PDF: ") + error.what());
  }
}

void writePdf(const Drawing& drawing, const std::filesystem::path& path, std::string_view description) {
  replaceFile(path, pdfOf(drawing, description));
}

}  // namespace velum::vector
