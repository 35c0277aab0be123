#include <fmt/format.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLImageDataWriter.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "io/Plugins.h"
#include "io/read/Losses.h"
#include "io/read/Refuse.h"
#include "io/read/VtkQuiet.h"
#include "io/volumes/Readers.h"
#include "io/volumes/VtiNotes.h"

namespace velum::io {

namespace {

int vtkTypeOf(SampleType type) {
  constexpr int kTypes[] = {VTK_UNSIGNED_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_SHORT, VTK_SHORT,
                            VTK_UNSIGNED_INT,  VTK_INT,         VTK_FLOAT,          VTK_DOUBLE};
  return kTypes[static_cast<int>(type)];
}

void addNote(vtkImageData& image, const char* name, double value) {
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->InsertNextValue(value);
  image.GetFieldData()->AddArray(array);
}

void addNote(vtkImageData& image, const char* name, const std::string& text) {
  if (text.empty()) return;
  vtkNew<vtkUnsignedCharArray> array;
  array->SetName(name);
  for (char c : text) array->InsertNextValue(static_cast<unsigned char>(c));
  image.GetFieldData()->AddArray(array);
}

/// VTK writes names of components as they are.
std::string escaped(const std::string& text) {
  std::string out;
  for (char c : text) {
    constexpr std::pair<char, const char*> kEntities[] = {
        {'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}};
    auto entity = std::find_if(std::begin(kEntities), std::end(kEntities), [&](auto& e) { return e.first == c; });
    bool isPlain = entity == std::end(kEntities);
    // Line ends and other characters without a picture cannot stand there.
    out += isPlain ? std::string(1, static_cast<unsigned char>(c) < ' ' ? ' ' : c) : entity->second;
  }
  return out;
}

void addNotes(vtkImageData& image, const Volume& volume) {
  addNote(image, vti::kScale, volume.scale);
  addNote(image, vti::kOffset, volume.offset);
  addNote(image, vti::kOriented, volume.isOrientationKnown ? 1.0 : 0.0);
  if (!volume.isSpacingKnown) addNote(image, vti::kSpacing, 0.0);
  // Who reads a file of others takes three or four bytes for a colour.
  bool looksColored = (volume.channels == 3 || volume.channels == 4) && volume.type == SampleType::UInt8;
  if (volume.isColor != looksColored) addNote(image, vti::kColor, volume.isColor ? 1.0 : 0.0);
  addNote(image, vti::kName, volume.name);
  addNote(image, vti::kUnit, volume.unit);
  if (volume.modality != Modality::Unknown) addNote(image, vti::kModality, std::string(enumName(volume.modality)));
  if (volume.lengthUnit != LengthUnit::Millimetre)
    addNote(image, vti::kLengthUnit, std::string(enumName(volume.lengthUnit)));
}

}  // namespace

std::vector<std::string> plugin::writeVti(const Volume& volume, ReplaceFile& file, Progress& progress) {
  const Path& path = file.target();
  if (volume.timeSteps > 1)
    refuse(path, fmt::format("a .vti holds one time step, not {}; write .nrrd or .nii", volume.timeSteps));
  progress.report(0, "writing VTK image");
  VtkQuiet quiet;
  vtkNew<vtkImageData> image;
  image->SetDimensions(volume.dims.x, volume.dims.y, volume.dims.z);
  glm::dmat4 world = worldFromVoxelIn(LengthUnit::Millimetre, volume);
  glm::dvec3 spacing = spacingOf(volume) * unitsPer(volume.lengthUnit, LengthUnit::Millimetre);
  glm::dmat3 axes = direction(volume);
  image->SetSpacing(spacing.x, spacing.y, spacing.z);
  image->SetOrigin(world[3].x, world[3].y, world[3].z);
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row) image->GetDirectionMatrix()->SetElement(row, column, axes[column][row]);

  // VTK borrows the voxels; it does not write to them.
  vtkSmartPointer<vtkDataArray> array = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(vtkTypeOf(volume.type)));
  array->SetNumberOfComponents(volume.channels);
  array->SetVoidArray(const_cast<std::byte*>(volume.voxels.data()), vtkIdType(voxelCount(volume)) * volume.channels, 1);
  array->SetName("scalars");
  image->GetPointData()->SetScalars(array);
  for (std::size_t i = 0; i < volume.channelNames.size(); ++i)
    array->SetComponentName(vtkIdType(i), escaped(volume.channelNames[i]).c_str());
  addNotes(*image, volume);

  vtkNew<vtkXMLImageDataWriter> writer;
  quiet.listen(*writer, &progress);
  // To memory: to a file the writer does not look whether its last bytes arrive.
  writer->WriteToOutputStringOn();
  writer->SetInputData(image);
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToZLib();
  writer->SetHeaderTypeToUInt64();
  int done = writer->Write();
  progress.throwIfCancelled();
  if (!done || !quiet.error().empty()) refuse(path, fmt::format("cannot be written ({})", quiet.error()));
  file.write(writer->GetOutputString());
  Losses losses;
  losses.say(volume.scale != 1.0 || volume.offset != 0.0,
             ".vti has no scale: other programs read stored samples, of which a value is {} times one plus {}",
             volume.scale, volume.offset);
  losses.say(volume.lengthUnit != LengthUnit::Millimetre,
             "lengths are written in mm: .vti has no unit of length for other programs");
  return losses.take();
}

}  // namespace velum::io
