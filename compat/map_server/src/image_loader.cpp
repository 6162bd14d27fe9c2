// SPDX-License-Identifier: BSD-3-Clause
#include <SDL/SDL_image.h>
#include <map_server/image_loader.h>
#include <tf2/LinearMath/Quaternion.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

namespace map_server {

Picture readPicture(const std::string& file, Mode mode) {
  const std::unique_ptr<SDL_Surface, void (*)(SDL_Surface*)> image(IMG_Load(file.c_str()), SDL_FreeSurface);
  if (!image) throw std::runtime_error("the map image \"" + file + "\" cannot be read: " + IMG_GetError());

  const SDL_PixelFormat& format = *image->format;
  Picture picture;
  picture.width = static_cast<unsigned int>(image->w);
  picture.height = static_cast<unsigned int>(image->h);
  picture.grey.reserve(std::size_t(picture.width) * picture.height);
  const unsigned int channels = format.BytesPerPixel;
  const bool has_opacity = format.Amask != 0;
  // A palette's index is a grey value only in a grey picture; SDL_GetRGBA is right for both.
  const bool by_palette = format.palette != nullptr;
  const bool average_opacity = has_opacity && mode == Mode::kTrinary;

  for (unsigned int y = 0; y < picture.height; ++y) {
    const auto* row = static_cast<const std::uint8_t*>(image->pixels) + y * image->pitch;
    for (unsigned int x = 0; x < picture.width; ++x) {
      const std::uint8_t* pixel = row + x * channels;
      std::uint8_t red = pixel[0], green = pixel[0], blue = pixel[0], opacity = 255;
      if (by_palette || channels > 1) {
        std::uint32_t packed = 0;
        std::copy_n(pixel, std::min<unsigned int>(channels, 4), reinterpret_cast<std::uint8_t*>(&packed));
        SDL_GetRGBA(packed, image->format, &red, &green, &blue, &opacity);
      }
      const double sum = double(red) + green + blue;
      picture.grey.push_back(average_opacity ? (sum + opacity) / 4.0 : sum / 3.0);
      if (has_opacity) picture.opacity.push_back(opacity);
    }
  }
  return picture;
}

signed char occupancy(double grey, std::uint8_t opacity, const MapDescription& description) {
  const double value = description.negate ? 255.0 - grey : grey;
  if (description.mode == Mode::kRaw) return static_cast<signed char>(value);
  const double probability = (255.0 - value) / 255.0;
  if (probability > description.occupied_thresh) return 100;
  if (probability < description.free_thresh) return 0;
  if (description.mode == Mode::kTrinary || opacity < 1) return -1;
  const double ratio =
      (probability - description.free_thresh) / (description.occupied_thresh - description.free_thresh);
  return static_cast<signed char>(1.0 + 98.0 * ratio);
}

nav_msgs::OccupancyGrid makeMap(const Picture& picture, const MapDescription& description) {
  nav_msgs::OccupancyGrid map;
  map.info.width = picture.width;
  map.info.height = picture.height;
  map.info.resolution = static_cast<float>(description.resolution);
  map.info.origin.position.x = description.origin[0];
  map.info.origin.position.y = description.origin[1];
  tf2::Quaternion orientation;
  orientation.setRPY(0.0, 0.0, description.origin[2]);
  map.info.origin.orientation.z = orientation.z();
  map.info.origin.orientation.w = orientation.w();

  map.data.reserve(picture.grey.size());
  for (std::size_t row = picture.height; row-- > 0;) {
    for (std::size_t i = row * picture.width; i < (row + 1) * picture.width; ++i) {
      const std::uint8_t opacity = picture.opacity.empty() ? std::uint8_t(255) : picture.opacity[i];
      map.data.push_back(occupancy(picture.grey[i], opacity, description));
    }
  }
  return map;
}

}  // namespace map_server
