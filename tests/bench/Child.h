#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

namespace velum::bench {

/// Runs this program anew as `velum-bench --child <arguments>`, so that memory and caches are its own.
/// @return what it printed; null when it failed
nlohmann::json runChild(const std::vector<std::string>& arguments,
                        const std::vector<std::pair<std::string, std::string>>& environment = {});

/// What children do; by their first argument. @return the exit status
int childMain(const std::vector<std::string>& arguments);

/// Reads a file and says {ms, peakMb}: time, and growth of the largest resident size. @param reader  velum, itk, vtk
nlohmann::json childRead(const std::string& reader, const std::string& path);
/// The first picture of a fresh process. @param size  voxels along each axis
nlohmann::json childFirstPicture(int size);
/// How soon section views answer a drag, by what the window does meanwhile: {medianMs, most90Ms, worstMs} each.
nlohmann::json childAnswers(int size);

/// Bytes read, for the readers below. @throw std::exception
std::size_t readWithItk(const std::string& path);
std::size_t readWithVtk(const std::string& path);

}  // namespace velum::bench
