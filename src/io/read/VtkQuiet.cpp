#include "io/read/VtkQuiet.h"

#include <vtkAlgorithm.h>
#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkXMLReader.h>

#include <algorithm>

#include "core/Error.h"

namespace velum::io {

namespace {

/// "ERROR: In file.cxx, line 3\nvtkThing (0x..): what\n\n" -> "what"
std::string oneLine(std::string text) {
  if (auto at = text.find("): "); at != text.npos) text.erase(0, at + 3);
  std::replace(text.begin(), text.end(), '\n', ' ');
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text.substr(0, 300);
}

}  // namespace

VtkQuiet::VtkQuiet() { vtkObject::GlobalWarningDisplayOff(); }

void VtkQuiet::observe(vtkObject* caller, unsigned long event, void* self, void* data) {
  auto& quiet = *static_cast<VtkQuiet*>(self);
  if (event == vtkCommand::ErrorEvent && quiet.mError.empty())
    quiet.mError = oneLine(data ? static_cast<const char*>(data) : "no reason given");
  if (event != vtkCommand::ProgressEvent || !quiet.mProgress) return;
  auto* algorithm = vtkAlgorithm::SafeDownCast(caller);
  // Nothing may be thrown through VTK; it is told to stop and the caller throws behind it.
  try {
    quiet.mProgress->report(std::clamp(algorithm->GetProgress(), 0.0, 1.0), "VTK");
  } catch (const Cancelled&) {
    algorithm->SetAbortExecute(1);
  }
}

void VtkQuiet::listen(vtkAlgorithm& algorithm, Progress* progress) {
  mProgress = progress;
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback(&VtkQuiet::observe);
  command->SetClientData(this);
  for (unsigned long event : {vtkCommand::ErrorEvent, vtkCommand::ProgressEvent}) algorithm.AddObserver(event, command);
  // Errors of the XML itself (a cut file, a number missing) come from the parser inside.
  if (auto* xml = vtkXMLReader::SafeDownCast(&algorithm))
    xml->SetParserErrorObserver(command), xml->SetReaderErrorObserver(command);
}

}  // namespace velum::io
