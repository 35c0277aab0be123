#pragma once
#include "core/Model.h"
#include "core/Task.h"
#include "io/models/ReadModel.h"
#include "io/read/Refuse.h"

/// The readers, each in the file of its name. The table in ReadModel.cpp lists them and chooses one by the file. They
/// compare every count with what the file can hold before they allocate, refuse places that are no numbers, and throw
/// InputError with the file's name and the reason.
namespace velum::io {

Model readBinaryCif(const Path& path, Progress& progress, const ModelReading& reading);
Model readCifText(const Path& path, Progress& progress, const ModelReading& reading);
Model readCellPackResults(const Path& path, Progress& progress, const ModelReading& reading);
Model readCellPackBinary(const Path& path, Progress& progress, const ModelReading& reading);
Model readPdb(const Path& path, Progress& progress, const ModelReading& reading);

}  // namespace velum::io
