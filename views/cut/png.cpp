#include "views/cut/png.hpp"

#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <string_view>
#include <vector>

#include "base/errors.hpp"

namespace bitrock::views {

namespace {

using Surface = std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)>;

cairo_status_t append(void* sink, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(sink)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

cairo_status_t take(void* source, unsigned char* data, unsigned int length) {
  auto& left = *static_cast<std::string_view*>(source);
  if (left.size() < length) return CAIRO_STATUS_READ_ERROR;
  std::memcpy(data, left.data(), length);
  left.remove_prefix(length);
  return CAIRO_STATUS_SUCCESS;
}

void require_drawn(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS)
    throw base::SimulationError(fmt::format("the picture could not be drawn: {}", cairo_status_to_string(status)));
}

}  // namespace

std::string png_of(cairo_surface_t* page) {
  std::string png;
  require_drawn(cairo_surface_write_to_png_stream(page, append, &png));
  return png;
}

std::string stacked(std::span<const std::string> pictures) {
  std::vector<Surface> parts;
  int width = 0, height = 0;
  for (const std::string& picture : pictures) {
    std::string_view left = picture;
    parts.emplace_back(cairo_image_surface_create_from_png_stream(take, &left), cairo_surface_destroy);
    require_drawn(cairo_surface_status(parts.back().get()));
    width = std::max(width, cairo_image_surface_get_width(parts.back().get()));
    height += cairo_image_surface_get_height(parts.back().get());
  }
  const Surface page(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height), cairo_surface_destroy);
  const std::unique_ptr<cairo_t, void (*)(cairo_t*)> cairo(cairo_create(page.get()), cairo_destroy);
  cairo_set_source_rgb(cairo.get(), 1.0, 1.0, 1.0);
  cairo_paint(cairo.get());
  double top = 0.0;
  for (const Surface& part : parts) {
    cairo_set_source_surface(cairo.get(), part.get(), 0.0, top);
    cairo_paint(cairo.get());
    top += cairo_image_surface_get_height(part.get());
  }
  require_drawn(cairo_status(cairo.get()));
  return png_of(page.get());
}

}  // namespace bitrock::views
