#include "scene/json/Json.h"

#include "core/Error.h"
#include "scene/Scene.h"
#include "scene/json/FieldJson.h"
#include "scene/json/JsonText.h"
#include "scene/json/OlderVersions.h"

namespace velum::scene {

namespace {

using detail::Json;

/// An object. @param what  "scene: "; begins the message  @throw InputError with the line where it is none
Json parseObject(std::string_view text, const std::string& what) {
  if (nestsTooDeep(text)) throw InputError(what + "brackets are nested deeper than in any scene");
  Json json;
  try {
    json = Json::parse(text);
  } catch (const Json::exception& error) {
    // "[json.exception...] parse error at line 3, column 5: syntax error ...; last read: ..."
    constexpr std::size_t kLongest = 160;  // of what was read last; a file can be all one string
    std::string_view said = error.what();
    said.remove_prefix(
        std::min(said.size(), said.find("line ") != said.npos ? said.find("line ") : said.find("] ") + 2));
    throw InputError(fmt::format("{}the text is no JSON; {}", what, printable(said.substr(0, kLongest))));
  }
  if (!json.is_object())
    throw InputError(what + "the text is not a JSON object; the file is damaged or of another kind");
  return json;
}

}  // namespace

std::string toJson(const Scene& scene) {
  Json out = Json::object();
  out["velum"] = kSceneVersion;
  out.update(detail::writeStruct(scene));
  // A path may hold bytes that are no UTF-8; JSON cannot.
  return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Scene fromJson(std::string_view text) {
  Json json = parseObject(text, "scene: ");
  auto version = json.find("velum");
  if (version == json.end() || !version->is_number_integer())
    throw InputError("scene: no \"velum\" version number; this is not a scene of ours");
  if (version->get<double>() > kSceneVersion || version->get<double>() < 1)
    throw InputError(
        fmt::format("scene: written by a newer Velum (scene version {}, this one reads up to {}); update Velum",
                    version->get<double>(), kSceneVersion));
  detail::bringUpToDate(json, version->get<int>());
  Scene scene;
  detail::readStruct(scene, json, "");
  completeItems(scene);
  return scene;
}

std::string transferToJson(const TransferFunction& transfer) {
  Json out = Json::object();
  out["velumTransfer"] = kTransferVersion;
  out.update(detail::writeStruct(transfer));
  return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

TransferFunction transferFromJson(std::string_view text) {
  Json json = parseObject(text, "transfer function: ");
  auto version = json.find("velumTransfer");
  if (version == json.end() || !version->is_number_integer())
    throw InputError("no \"velumTransfer\" version number; this is not a transfer function of ours, or it is damaged");
  if (version->get<double>() > kTransferVersion || version->get<double>() < 1)
    throw InputError(
        fmt::format("written by a newer Velum (transfer version {}, this one reads up to {}); update Velum",
                    version->get<double>(), kTransferVersion));
  json.erase("velumTransfer");
  TransferFunction transfer;
  detail::readStruct(transfer, json, "transfer");
  return transfer;
}

}  // namespace velum::scene
