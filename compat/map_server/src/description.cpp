// SPDX-License-Identifier: BSD-3-Clause
#include <map_server/image_loader.h>
#include <yaml-cpp/yaml.h>

#include <stdexcept>

namespace map_server {
namespace {

template <typename Value>
Value required(const YAML::Node& document, const std::string& file, const char* key) {
  if (!document[key]) throw std::runtime_error("the map description \"" + file + "\" has no \"" + key + "\"");
  try {
    return document[key].as<Value>();
  } catch (const YAML::Exception&) {
    throw std::runtime_error("the map description \"" + file + "\": \"" + key + "\" is not of the right kind");
  }
}

Mode readMode(const YAML::Node& document, const std::string& file) {
  if (!document["mode"]) return Mode::kTrinary;
  const auto name = required<std::string>(document, file, "mode");
  if (name == "trinary") return Mode::kTrinary;
  if (name == "scale") return Mode::kScale;
  if (name == "raw") return Mode::kRaw;
  throw std::runtime_error("the map description \"" + file + "\": mode is \"" + name +
                           "\"; it must be trinary, scale or raw");
}

// Relative to the folder of the YAML file.
std::string imagePath(const std::string& image, const std::string& yaml_file) {
  if (image.empty()) throw std::runtime_error("the map description \"" + yaml_file + "\": \"image\" is empty");
  const std::size_t slash = yaml_file.rfind('/');
  return image[0] == '/' || slash == std::string::npos ? image : yaml_file.substr(0, slash + 1) + image;
}

}  // namespace

MapDescription readDescription(const std::string& yaml_file) {
  YAML::Node document;
  try {
    document = YAML::LoadFile(yaml_file);
  } catch (const YAML::Exception& fault) {
    throw std::runtime_error("the map description \"" + yaml_file + "\" cannot be read: " + fault.what());
  }
  if (!document.IsMap()) throw std::runtime_error("\"" + yaml_file + "\" is not a map description (YAML)");
  MapDescription description;
  description.image = imagePath(required<std::string>(document, yaml_file, "image"), yaml_file);
  description.resolution = required<double>(document, yaml_file, "resolution");
  description.origin = required<std::array<double, 3>>(document, yaml_file, "origin");
  description.occupied_thresh = required<double>(document, yaml_file, "occupied_thresh");
  description.free_thresh = required<double>(document, yaml_file, "free_thresh");
  description.mode = readMode(document, yaml_file);
  const auto negate = required<std::string>(document, yaml_file, "negate");
  description.negate = negate == "1" || negate == "true";
  if (!(description.resolution > 0.0)) {
    throw std::runtime_error("the map description \"" + yaml_file + "\": resolution must be positive [m/pixel]");
  }
  return description;
}

}  // namespace map_server
