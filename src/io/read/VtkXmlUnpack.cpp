#include <vtkLZ4DataCompressor.h>
#include <vtkLZMADataCompressor.h>
#include <vtkNew.h>

#include "io/Plugins.h"
#include "io/read/VtkQuiet.h"
#include "io/read/VtkXml.h"

namespace velum::io {

std::size_t plugin::unpackByVtk(VtkPacking packing, std::span<const std::byte> from, std::span<std::byte> to) {
  VtkQuiet quiet;
  vtkNew<vtkLZ4DataCompressor> lz4;
  vtkNew<vtkLZMADataCompressor> lzma;
  vtkDataCompressor* codec = lz4;
  if (packing == VtkPacking::Lzma) codec = lzma;
  return codec->Uncompress(reinterpret_cast<const unsigned char*>(from.data()), from.size(),
                           reinterpret_cast<unsigned char*>(to.data()), to.size());
}

}  // namespace velum::io
