#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkXMLImageDataReader.h>

#include "Child.h"

namespace velum::bench {

std::size_t readWithVtk(const std::string& path) {
  vtkNew<vtkXMLImageDataReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return std::size_t(reader->GetOutput()->GetActualMemorySize()) * 1024;
}

}  // namespace velum::bench
