// SPDX-License-Identifier: LGPL-3.0-or-later

#include "output/write_mesh.h"

#include "input/vertex_data.h"
#include "output/text_writer.h"
#include "output/texture_places.h"

#include <CGAL/boost/graph/iterator.h>

#include <png.h>

#include <stdexcept>

namespace tool {

void write_textured_obj(std::ostream& out, const Mesh& mesh, const std::vector<Uv>& uv,
                        const std::string& material_file)
{
  Text_writer write(out);
  write("mtllib ", material_file, "\nusemtl texture\n");
  for(const Point& p : mesh.points())
    write("v ", p, '\n');

  const Texture_places places(mesh, uv);
  for(const auto& [u, v] : places.place)
    write("vt ", u, ' ', v, '\n');
  for(const Mesh::Face_index f : faces(mesh)) {
    write('f');
    for(const Mesh::Halfedge_index h : CGAL::halfedges_around_face(halfedge(f, mesh), mesh))
      write(' ', target(h, mesh).idx() + 1, '/', places.number[h.idx()] + 1);
    write('\n');
  }
}

void write_material(std::ostream& out, const std::string& image_file)
{
  out << "newmtl texture\nKa 0 0 0\nKd 1 1 1\nKs 0 0 0\nillum 1\nmap_Kd " << image_file << '\n';
}

void write_checker(std::ostream& out, int columns, int rows)
{
  constexpr int square = 32; // pixels
  const int width = square * columns, height = square * rows;
  std::vector<png_byte> pixels;
  pixels.reserve(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for(int y = 0; y < height; ++y)
    for(int x = 0; x < width; ++x) {
      const int column = x / square, row = y / square;
      const bool is_white = (column + row) % 2 == 0;
      for(const double pure : colour_of_hue((column + 0.5) / columns))
        pixels.push_back(is_white ? 250 : static_cast<png_byte>(30 + 170 * pure));
    }

  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(height);
  image.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = 0;
  std::vector<char> file;
  const auto write = [&](void* memory) {
    if(png_image_write_to_memory(&image, memory, &size, 0, pixels.data(), 0, nullptr) == 0)
      throw std::runtime_error(std::string("libpng: ") + image.message);
  };
  write(nullptr); // which says how large it is
  file.resize(size);
  write(file.data());
  out.write(file.data(), static_cast<std::streamsize>(size));
}

} // namespace tool
