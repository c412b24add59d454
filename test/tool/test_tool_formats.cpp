// SPDX-License-Identifier: GPL-3.0-or-later
// The formats of meshes: what is written is read back equal, here and by other programs; what is broken is refused.

#include "helpers/arrays.h"
#include "helpers/meshes.h"
#include "helpers/tool.h"

#include "input/binary.h"
#include "input/mesh.h"
#include "input/mesh_format.h"
#include "input/mesh_readers.h"
#include "input/text_lines.h"
#include "input/text_pieces.h"
#include "output/atomic_file.h"
#include "output/write_mesh.h"
#include "system/refusal.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <numeric>
#include <sstream>
#include <string>
#include <vector>

using namespace test;
using namespace std::string_literals;
namespace fs = std::filesystem;

namespace {

/// All coordinates as a file of the format has them.
std::vector<tool::Point> all_as_stored(tool::Mesh_format format, tool::Surface surface, std::vector<tool::Point> points)
{
  for(tool::Point& p : points)
    p = tool::as_stored(format, surface, p);
  return points;
}

tool::Input_mesh input_of(const Soup& soup)
{
  std::vector<tool::Point> points;
  for(const Point& p : soup.points)
    points.push_back({p.x(), p.y(), p.z()});
  return {tool::Mesh(points, soup.faces), 0, {}};
}

void write(const std::string& file, const tool::Output_format& format, const tool::Input_mesh& mesh,
           tool::Surface surface = tool::Surface::SHAPE)
{
  tool::Atomic_files out;
  tool::write_mesh(out.open(file), format, mesh.mesh, mesh.mesh.points(), surface, mesh.annotations);
  out.commit();
}

bool have_same_triangles(const tool::Mesh& a, const tool::Mesh& b)
{
  bool same = a.number_of_faces() == b.number_of_faces();
  for(std::size_t f = 0; same && f < a.number_of_faces(); ++f)
    same = a.triangle(f) == b.triangle(f);
  return same;
}

/// What a reader says of a file that it refuses.
std::string refusal(const std::string& file)
{
  try {
    tool::read_mesh(file);
  } catch(const tool::Refusal& refusal) {
    return refusal.what();
  }
  return "not refused";
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

bool runs(const std::vector<std::string>& command) { return run_process(command).exit_code == 0; }

} // namespace

TEST_CASE("formats: what is written is read back equal", "[tool][formats]")
{
  Scratch scratch;
  tool::Input_mesh mesh = input_of(bumpy_sphere(3));
  const auto surface = GENERATE(tool::Surface::SHAPE, tool::Surface::SPHERE);
  for(const auto& [name, format] : tool::output_formats())
    for(const bool ascii : {false, true})
      for(const std::string compression : {"", ".gz", ".xz", ".zst", ".bz2"}) {
        const std::string file = scratch / ("copy." + name + compression);
        CAPTURE(file, ascii);
        write(file, {format, ascii}, mesh, surface);
        const tool::Mesh copy = tool::read_mesh(file).mesh;
        CHECK((copy.points() == all_as_stored(format, surface, mesh.mesh.points())));
        CHECK(have_same_triangles(copy, mesh.mesh));
        CHECK((tool::stores_floats(format) || copy.points() == mesh.mesh.points()));
        fs::remove(file);
      }
}

TEST_CASE("formats: numbers beyond the range of doubles are infinite or zero", "[tool][formats]")
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for(const auto& [text, expected] :
      {std::pair("1.5e400", infinity), {"-1.5e400", -infinity}, {"+1.5e-400", 0.}, {"1.5e-320", 1.5e-320}}) {
    double value = 7;
    CAPTURE(text);
    CHECK((tool::to_number(text, value) == tool::Number::FINITE) == std::isfinite(expected));
    CHECK(value == expected);
    float rounded = 7;
    tool::to_number(text, rounded);
    CHECK(rounded == static_cast<float>(expected));
  }
}

TEST_CASE("formats: zeros behind compressed bytes are nothing", "[tool][formats]")
{
  Scratch scratch;
  const tool::Input_mesh mesh = input_of(icosphere(1));
  write(scratch / "in.off.gz", {tool::Mesh_format::OFF}, mesh);
  const std::string bytes = text_of(scratch / "in.off.gz");
  write_text(scratch / "padded.off.gz", bytes + std::string(700, '\0'));
  CHECK((tool::read_mesh(scratch / "padded.off.gz").mesh.points() == mesh.mesh.points()));
  write_text(scratch / "followed.off.gz", bytes + std::string(700, '\0') + "x");
  CHECK(contains(refusal(scratch / "followed.off.gz"), "damaged"));
}

TEST_CASE("formats: neuroimaging files keep what they say beside the surface", "[tool][formats]")
{
  Scratch scratch;
  tool::Input_mesh mesh = input_of(icosphere(1));
  mesh.annotations.gifti = {{"Subject", "a < b & c"}};
  mesh.annotations.gifti_points = {{"AnatomicalStructurePrimary", "CortexLeft"}, {"GeometricType", "Anatomical"}};
  mesh.annotations.gifti_transforms = {
    {"NIFTI_XFORM_UNKNOWN", "NIFTI_XFORM_TALAIRACH", "1 0 0 5 0 1 0 0 0 0 1 0 0 0 0 1"}};
  mesh.annotations.freesurfer = "\0\0\0\x14valid = 1  # volume info valid\n"s;

  write(scratch / "in.gii", {tool::Mesh_format::GIFTI}, mesh);
  write(scratch / "in.sphere.gii", {tool::Mesh_format::GIFTI}, mesh, tool::Surface::SPHERE);
  write(scratch / "lh.white", {tool::Mesh_format::FREESURFER}, mesh);
  const tool::Annotations gifti = tool::read_mesh(scratch / "in.gii").annotations;
  CHECK((gifti.gifti == mesh.annotations.gifti));
  CHECK((gifti.gifti_points == mesh.annotations.gifti_points));
  CHECK((gifti.gifti_transforms == mesh.annotations.gifti_transforms));
  CHECK((tool::read_mesh(scratch / "in.sphere.gii").annotations.gifti_points ==
         tool::Annotations::Metadata{{"AnatomicalStructurePrimary", "CortexLeft"}, {"GeometricType", "Spherical"}}));
  CHECK((tool::read_mesh(scratch / "lh.white").annotations.freesurfer == mesh.annotations.freesurfer));
}

TEST_CASE("formats: the volume geometry goes from FreeSurfer's files to GIFTI and back", "[tool][formats]")
{
  Scratch scratch;
  const std::string lines = "valid = 1  # volume info valid\nfilename = unknown\nvolume = 256 255 254\n"
                            "voxelsize = 1.0e+00 1 0.5\nxras = -1 0 0\nyras = 0 0 -1\nzras = 0 1 0\ncras = 5.4 18 0\n";
  tool::Input_mesh mesh = input_of(icosphere(1));
  mesh.annotations.freesurfer = std::string("\0\0\0\2\0\0\0\0\0\0\0\x14", 12) + lines;
  write(scratch / "lh.white", {tool::Mesh_format::FREESURFER}, mesh);
  write(scratch / "white.gii", {tool::Mesh_format::GIFTI}, tool::read_mesh(scratch / "lh.white"));
  const tool::Input_mesh gifti = tool::read_mesh(scratch / "white.gii");
  CHECK(gifti.annotations.gifti_points.size() == 18);
  CHECK((gifti.annotations.gifti_points[1] == std::pair<std::string, std::string>("VolGeomHeight", "255")));
  CHECK((gifti.annotations.gifti_points.back() == std::pair<std::string, std::string>("VolGeomC_S", "0")));
  write(scratch / "rh.white", {tool::Mesh_format::FREESURFER}, gifti);
  CHECK((tool::read_mesh(scratch / "rh.white").annotations.freesurfer == mesh.annotations.freesurfer));
}

TEST_CASE("formats: long texts are read in pieces, with the same result", "[tool][formats]")
{
  Scratch scratch;
  const bool is_off = GENERATE(true, false);
  const auto read = [&](const std::string& text) {
    return is_off ? tool::read_off("file", text) : tool::read_obj("file", text);
  };
  const auto text_of_refusal = [&](const std::string& text) {
    try {
      read(text);
    } catch(const tool::Refusal& refusal) {
      return std::string(refusal.what());
    }
    return std::string("none");
  };
  const tool::Input_mesh mesh = input_of(icosphere(6));
  const std::string name = scratch / (is_off ? "in.off" : "in.obj");
  write(name, {is_off ? tool::Mesh_format::OFF : tool::Mesh_format::OBJ}, mesh);
  const std::string text = text_of(name);
  REQUIRE(tool::pieces_of(text).size() > 3);
  const auto end_of_line = [&](std::size_t share) { return text.find('\n', text.size() / 8 * share); };
  const auto with = [&](std::size_t share, const std::string& more) {
    return std::string(text).insert(end_of_line(share) + 1, more);
  };
  const auto with_ends = [&](const std::string& end) {
    std::string result;
    for(const std::string& line : lines_of(text))
      result += line + end;
    return result;
  };
  const auto check_same = [&](const tool::Soup& soup) {
    CHECK(soup.points == mesh.mesh.points());
    CHECK(soup.faces == mesh.mesh.number_of_faces());
    bool is_same = soup.triangles.size() == soup.faces;
    for(std::size_t f = 0; is_same && f < soup.faces; ++f)
      is_same = soup.triangles[f] == mesh.mesh.triangle(f);
    CHECK(is_same);
  };
  check_same(read(text));
  check_same(read(with(7, "# a comment\n")));
  check_same(read(with(1, "\n") + "\n\n"));
  check_same(read(with_ends("\r\n")));
  check_same(read(with_ends("\r")));
  check_same(read(with_ends(" # to the end of the line\n")));

  const std::size_t line =
    static_cast<std::size_t>(std::count(text.begin(), text.begin() + std::ptrdiff_t(end_of_line(7)), '\n')) + 2;
  CHECK(contains(text_of_refusal(with(7, "?\n")), "line " + std::to_string(line) + ": "));
  CHECK(contains(text_of_refusal(text.substr(0, end_of_line(7)) + " 4\n3 1\n"), "line "));
  std::string not_finite = text;
  const std::size_t minus = not_finite.find(" -", text.size() / 8) + 1;
  not_finite.replace(minus, not_finite.find_first_of(" \n", minus) - minus, "nan");
  REQUIRE(read(not_finite).non_finite);
  CHECK(contains(read(not_finite).non_finite->what(), "has the coordinate 'nan'"));

  if(!is_off) {
    check_same(read(text + "g of \\\nno faces\n"));
    const std::size_t n = mesh.mesh.number_of_vertices();
    const tool::Soup more = read(text + "f 1 2 3 4\nf -1 -2 -3 -4 -5\n");
    CHECK(more.polygons.size() == 2);
    CHECK(more.polygons[0].face == mesh.mesh.number_of_faces());
    CHECK((more.triangles.back() == std::array<int, 3>{int(n) - 1, int(n) - 4, int(n) - 5}));
    CHECK(contains(text_of_refusal(text + "f 1 2 " + std::to_string(n + 1) + "\n"), "there are only"));
  }
  const tool::Soup polygons = read([&] {
    std::string result = text;
    const std::string four = is_off ? "\n4 5 6 7 8" : "\nf 6 7 8 9";
    const std::size_t begin = end_of_line(6);
    return result.replace(begin, result.find('\n', begin + 1) - begin, four);
  }());
  CHECK(polygons.polygons.size() == 1);
  CHECK(polygons.triangles.size() == polygons.faces + 1);
  CHECK((polygons.triangles[polygons.polygons[0].face + 1] == std::array<int, 3>{5, 7, 8}));
}

TEST_CASE("formats: the content decides, whatever the name says", "[tool][formats]")
{
  Scratch scratch;
  const tool::Input_mesh mesh = input_of(bumpy_sphere(1));
  for(const auto& [name, format] : tool::output_formats())
    for(const char* other :
        {"file", "file.off", "file.PLY", "file.obj", "file.stl", "file.gii", "file.glb.gz", "a.b"}) {
      CAPTURE(name, other);
      write(scratch / "good", {format}, mesh);
      fs::rename(scratch / "good", scratch / other);
      CHECK((tool::read_mesh(scratch / other).mesh.points() ==
             all_as_stored(format, tool::Surface::SHAPE, mesh.mesh.points())));
      fs::remove(scratch / other);
    }
  write_text(scratch / "unknown.xyz", "1 2 3\n4 5 6\n");
  CHECK(contains(refusal(scratch / "unknown.xyz"), "unknown extension '.xyz'"));
}

TEST_CASE("formats: map writes spheres as the programs of the field expect them", "[tool][formats]")
{
  Scratch scratch;
  const std::string input = write_off(scratch / "in.off", bumpy_sphere(3));
  REQUIRE(run_tool({"map", input, "-o", scratch / "sphere.off"}).exit_code == 0);
  for(const char* name : {"lh.sphere", "sphere.gii", "sphere.surf.gii.gz", "sphere.glb", "sphere.gltf", "sphere.ply"}) {
    const Process_result run = run_tool({"map", input, "-o", scratch / name});
    CAPTURE(name, run.err);
    REQUIRE(run.exit_code == 0);
    CHECK(contains(run.out, "valid spherical map: 0 flipped faces, degree 1"));
    const double radius = tool::radius_of_spheres(*tool::format_of_name(name));
    CHECK(radius == (contains(name, "gii") || contains(name, "lh.") ? 100 : 1));
    const tool::Point p = tool::read_mesh(scratch / name).mesh.points().front();
    CHECK(std::hypot(p[0], p[1], p[2]) == Approx(radius));
    CHECK(run_tool({"segment", input, "--sphere", scratch / name, "-o", scratch / "out.ply"}).exit_code == 0);
  }
  CHECK(run_tool({"map", input, "-o", scratch / "any name", "--format", "freesurfer"}).exit_code == 0);
  CHECK((text_of(scratch / "any name") == text_of(scratch / "lh.sphere")));

  const std::string program = R"(
import sys
try:
  import nibabel, numpy
except ImportError:
  sys.exit(77)
folder = sys.argv[1]
lines = open(folder + '/sphere.off').read().splitlines()
vertices, faces = map(int, lines[1].split()[:2])
sphere = numpy.array([list(map(float, l.split())) for l in lines[2:2 + vertices]])
triangles = numpy.array([list(map(int, l.split()))[1:] for l in lines[2 + vertices:]])
expected = (100 * sphere).astype(numpy.float32)
points, cells = nibabel.freesurfer.read_geometry(folder + '/lh.sphere')
assert (points == expected).all() and (cells == triangles).all()
for name in 'sphere.gii', 'sphere.surf.gii.gz':
  image = nibabel.load(folder + '/' + name)
  assert (image.agg_data('pointset') == expected).all() and (image.agg_data('triangle') == triangles).all()
)";
  const Process_result judge = run_process({"/usr/bin/python3", "-W", "ignore", "-c", program, scratch.folder()});
  if(judge.exit_code == 77 || judge.exit_code == 127)
    std::cout << "SKIPPED: no nibabel to read the files with (Debian: python3-nibabel)" << std::endl;
  else {
    CAPTURE(judge.err);
    CHECK(judge.exit_code == 0);
  }
}

TEST_CASE("formats: a sphere that floats cannot hold is refused, not written", "[tool][formats]")
{
  Scratch scratch;
  const std::string input = write_off(scratch / "in.off", capsule(9, 12));
  CHECK(run_tool({"map", input, "-o", scratch / "out.ply", "--method", "balanced"}).exit_code == 0);
  for(const char* name : {"out.gii", "out.glb", "lh.out"}) {
    const Process_result run = run_tool({"map", input, "-o", scratch / name, "--method", "balanced"});
    CAPTURE(name, run.out, run.err);
    CHECK(run.exit_code == 1);
    CHECK(is_one_line(run.err));
    CHECK(contains(run.err, "faces flip when the sphere is rounded to the floats"));
    CHECK_FALSE(fs::exists(scratch / name));
  }
  const Process_result resampled =
    run_tool({"resample", write_off(scratch / "ball.off", icosphere(1)), "-o", scratch / "new.off", "--to-sphere",
              scratch / "out.ply", "--output-sphere", scratch / "new.gii"});
  CHECK(resampled.exit_code == 1);
  CHECK(contains(resampled.err, "new.gii: "));
  CHECK(contains(resampled.err, "faces flip when the sphere is rounded to the floats"));
  CHECK_FALSE(fs::exists(scratch / "new.gii"));
}

TEST_CASE("formats: shapes beyond the range of floats are refused, not written", "[tool][formats]")
{
  Scratch scratch;
  const double size = GENERATE(1e-300, 1e-30, 1e30, 1e300);
  Soup soup = bumpy_sphere(1);
  for(Point& p : soup.points)
    p = Point(size * p.x(), size * p.y(), size * p.z());
  const std::string input = write_off(scratch / "in.off", soup);
  CHECK(run_tool({"prepare", input, "-o", scratch / "out.obj"}).exit_code == 0);
  for(const char* name : {"out.gii", "out.glb", "out.gltf", "lh.out", "texture.glb"}) {
    const std::string command = contains(name, "texture") ? "texture" : "prepare";
    const Process_result run = run_tool({command, input, "-o", scratch / name});
    CAPTURE(size, name, run.out, run.err);
    const bool has_floats = size > 1e-38 && size < 1e38;
    CHECK(run.exit_code == (has_floats ? 0 : 1));
    CHECK(fs::exists(scratch / name) == has_floats);
    if(!has_floats) {
      CHECK(is_one_line(run.err));
      CHECK(contains(run.err, size < 1 ? "is below their range; write .ply, .off or .obj\n"
                                       : "is above their range; write .ply, .off or .obj\n"));
    }
  }
}

TEST_CASE("formats: textured glTF has the image inside", "[tool][formats]")
{
  Scratch scratch;
  const Soup soup = bumpy_sphere(3);
  const std::string input = write_off(scratch / "in.off", soup);
  const std::string chart = GENERATE("latitude-longitude", "octahedral");
  for(const char* name : {"out.glb", "out.gltf"}) {
    const Process_result run = run_tool({"texture", input, "-o", scratch / name, "--chart", chart});
    CAPTURE(name, run.err);
    REQUIRE(run.exit_code == 0);
    const tool::Mesh mesh = tool::read_mesh(scratch / name).mesh; // whose copies of vertices are one again
    CHECK(mesh.number_of_vertices() == soup.points.size());
    CHECK(mesh.number_of_faces() == soup.faces.size());
    if(!runs({"/usr/bin/assimp", "version"})) {
      std::cout << "SKIPPED: no assimp to read the file with (Debian: assimp-utils)" << std::endl;
      continue;
    }
    const Process_result info = run_process({"/usr/bin/assimp", "info", scratch / name});
    CAPTURE(info.out, info.err);
    CHECK(info.exit_code == 0);
    CHECK(contains(info.out, "Faces:              " + std::to_string(soup.faces.size())));
    CHECK(contains(info.out, "Textures (embed.):  1"));
  }
  CHECK(scratch.number_of_files() == 3);
  const std::string png = "\x89PNG\r\n\x1a\n";         // the header will do
  for(const char* rest : {"1", "12", "123", "1234"}) { // the parts of a GLB end at multiples of four
    write_text(scratch / "image.png", png + rest);
    REQUIRE(run_tool({"texture", input, "-o", scratch / "x.glb", "--image", scratch / "image.png", "--chart", chart})
              .exit_code == 0);
    const std::string glb = text_of(scratch / "x.glb");
    CHECK(glb.size() % 4 == 0);
    CHECK(contains(glb, png + rest));
  }
  write_text(scratch / "image.gif", "GIF89a");
  const Process_result run = run_tool({"texture", input, "-o", scratch / "x.glb", "--image", scratch / "image.gif"});
  CHECK(run.exit_code == 1);
  CHECK(contains(run.err, "neither PNG nor JPEG"));
}

TEST_CASE("formats: the texture coordinates of glTF are those of OBJ, counted from above", "[tool][formats]")
{
  Scratch scratch;
  const std::string input = write_off(scratch / "in.off", bumpy_sphere(2));
  REQUIRE(run_tool({"texture", input, "-o", scratch / "out.obj"}).exit_code == 0);
  REQUIRE(run_tool({"texture", input, "-o", scratch / "out.gltf"}).exit_code == 0);
  const auto json = nlohmann::json::parse(text_of(scratch / "out.gltf"));
  const auto& primitive = json["meshes"][0]["primitives"][0];
  const auto& accessor = json["accessors"][primitive["attributes"]["TEXCOORD_0"].get<int>()];
  const std::string uri = json["buffers"][0]["uri"];
  const std::string bytes = *tool::from_base64(std::string_view(uri).substr(uri.find(',') + 1));
  std::size_t at = json["bufferViews"][accessor["bufferView"].get<int>()]["byteOffset"];
  std::size_t count = 0;
  for(const std::string& line : lines_of(text_of(scratch / "out.obj")))
    if(line.compare(0, 3, "vt ") == 0) {
      std::istringstream in(line.substr(3));
      double u = 0, v = 0;
      in >> u >> v;
      CHECK(tool::number_at<float>(&bytes[at]) == u);
      CHECK(1 - double(tool::number_at<float>(&bytes[at + 4])) == v);
      at += 8;
      ++count;
    }
  CHECK(count == accessor["count"]);
}

TEST_CASE("formats: glTF is read in the space of its scene", "[tool][formats]")
{
  Scratch scratch;
  const tool::Input_mesh mesh = input_of(bumpy_sphere(1));
  write(scratch / "in.gltf", {tool::Mesh_format::GLTF}, mesh);
  const auto good = nlohmann::json::parse(text_of(scratch / "in.gltf"));
  const auto with = [&](const std::function<void(nlohmann::json&)>& change) {
    nlohmann::json json = good;
    change(json);
    write_text(scratch / "in.gltf", json.dump());
    return scratch / "in.gltf";
  };

  SECTION("nodes move their meshes; a mirror does not turn the mesh inside out")
  {
    const tool::Mesh moved =
      tool::read_mesh(with([](auto& json) {
        json["nodes"] = {{{"children", {1}}, {"scale", {-2, 2, 2}}}, {{"mesh", 0}, {"translation", {1, 0, 0}}}};
      }))
        .mesh;
    const auto stored = all_as_stored(tool::Mesh_format::GLTF, tool::Surface::SHAPE, mesh.mesh.points());
    for(std::size_t v = 0; v < stored.size(); ++v)
      CHECK((moved.points()[v] == tool::Point{-2 * (stored[v][0] + 1), 2 * stored[v][1], 2 * stored[v][2]}));
    const auto [a, b, c] = mesh.mesh.triangle(0);
    CHECK((moved.triangle(0) == std::array<int, 3>{a, c, b}));
  }
  SECTION("what has bones is where they put it, at rest its own place")
  {
    const tool::Mesh moved = tool::read_mesh(with([](auto& json) {
                               json["nodes"] = {{{"mesh", 0}, {"skin", 0}, {"scale", {5, 1, 1}}}};
                             }))
                               .mesh;
    CHECK(moved.points() == all_as_stored(tool::Mesh_format::GLTF, tool::Surface::SHAPE, mesh.mesh.points()));
  }
  SECTION("the bytes may be in a file next to it, and nowhere else")
  {
    const std::string uri = good["buffers"][0]["uri"];
    write_text(scratch / "in.bin", *tool::from_base64(std::string_view(uri).substr(uri.find(',') + 1)));
    CHECK(tool::read_mesh(with([](auto& json) { json["buffers"][0]["uri"] = "in.bin"; })).mesh.number_of_faces() ==
          mesh.mesh.number_of_faces());
    fs::rename(scratch / "in.bin", scratch / "my 100% mesh.bin"); // URIs have no spaces
    CHECK(tool::read_mesh(with([](auto& json) { json["buffers"][0]["uri"] = "my%20100%25%20mesh.bin"; }))
            .mesh.number_of_faces() == mesh.mesh.number_of_faces());
    for(const char* outside : {"../in.bin", "%2e%2E/in.bin", "/etc/passwd", "https://example.org/in.bin"})
      CHECK(contains(refusal(with([&](auto& json) { json["buffers"][0]["uri"] = outside; })), "no file next to it"));
  }
  SECTION("what is wrong is said")
  {
    CHECK(contains(refusal(with([](auto& json) { json["extensionsRequired"] = {"KHR_draco_mesh_compression"}; })),
                   "without compression"));
    CHECK(contains(refusal(with([](auto& json) { json["extensionsRequired"] = {"ACME_foo"}; })), "'ACME_foo'"));
    CHECK(contains(refusal(with([](auto& json) { json["asset"]["minVersion"] = "2.1"; })), "version \"2.1\""));
    CHECK(contains(refusal(with([](auto& json) { json["accessors"][0].erase("bufferView"); })), "no bufferView"));
    CHECK(contains(refusal(with([](auto& json) { json["accessors"][0]["count"] = 1000000000; })), "cut short"));
    CHECK(contains(refusal(with([](auto& json) { json["accessors"][0]["count"] = -1; })), "number"));
    CHECK(contains(refusal(with([](auto& json) { json["nodes"][0]["children"] = {0}; })), "two parents"));
    CHECK(contains(refusal(with([](auto& json) { json["bufferViews"][0]["byteOffset"] = 1e300; })), "number"));
    CHECK(contains(refusal(with([](auto& json) { json["nodes"][0]["mesh"] = 7; })), "missing"));
    CHECK(contains(refusal(with([](auto& json) { json["buffers"][0]["uri"] = "data:;base64,????"; })), "Base64"));
    CHECK(contains(refusal(with([](auto& json) { json.erase("scenes"), json.erase("meshes"); })), "no triangles"));
    write_text(scratch / "deep.gltf", "{\"asset\":" + std::string(100000, '['));
    CHECK(contains(refusal(scratch / "deep.gltf"), "no JSON"));
  }
}

TEST_CASE("formats: extensions of glTF that leave the shape as it is do not matter", "[tool][formats]")
{
  Scratch scratch;
  write(scratch / "in.gltf", {tool::Mesh_format::GLTF}, input_of(icosphere(1)));
  auto json = nlohmann::json::parse(text_of(scratch / "in.gltf"));
  json["extensionsRequired"] = {"KHR_mesh_quantization", "KHR_materials_unlit", "KHR_texture_transform"};
  write_text(scratch / "in.gltf", json.dump());
  CHECK(tool::read_mesh(scratch / "in.gltf").mesh.number_of_faces() == 80);
}

TEST_CASE("formats: floats do not take a shape that is far from the origin", "[tool][formats]")
{
  Scratch scratch;
  const auto at = [&](double distance) {
    return write_off(scratch / "in.off", transformed(bumpy_sphere(2), [=](const Point& p) {
                       return Point(p.x() + distance, p.y(), p.z());
                     }));
  };
  for(const char* name : {"out.glb", "out.gii", "lh.out"}) {
    CAPTURE(name);
    CHECK(run_tool({"resample", at(1e4), "-o", scratch / name, "--level", "2"}).exit_code == 0);
    const Process_result run = run_tool({"resample", at(1e6), "-o", scratch / name, "--level", "2"});
    CHECK(run.exit_code == 1);
    CHECK(contains(run.err, "far from the origin; write .ply, .off or .obj, or move the mesh"));
  }
  CHECK(run_tool({"texture", at(1e6), "-o", scratch / "out.glb"}).exit_code == 1);
  CHECK(run_tool({"map", at(1e6), "-o", scratch / "out.gii"}).exit_code == 0); // a sphere
}

TEST_CASE("formats: comments before the format of PLY, and frames of zstd that are to be skipped", "[tool][formats]")
{
  Scratch scratch;
  std::string text = text_of([&] {
    write(scratch / "in.ply", {tool::Mesh_format::PLY}, input_of(icosphere(1)));
    return scratch / "in.ply";
  }());
  write_text(scratch / "in.ply", text.insert(4, "comment of mine\nobj_info more\n"));
  CHECK(tool::read_mesh(scratch / "in.ply").mesh.number_of_faces() == 80);
  write(scratch / "in.off.zst", {tool::Mesh_format::OFF}, input_of(icosphere(1)));
  write_text(scratch / "in.off.zst", "\x50\x2a\x4d\x18\x04\0\0\0skip"s + text_of(scratch / "in.off.zst"));
  CHECK(tool::read_mesh(scratch / "in.off.zst").mesh.number_of_faces() == 80);
}

TEST_CASE("formats: triangle strips are the triangles that they stand for", "[tool][formats]")
{
  Scratch scratch;
  // an antiprism: the triangles around it, and both ends
  const std::vector<std::array<int, 3>> expected = {{0, 3, 1}, {1, 3, 4}, {1, 4, 2}, {2, 4, 5},
                                                    {0, 2, 5}, {0, 5, 3}, {0, 1, 2}, {3, 5, 4}};
  const std::string points = "2 0 1\n-1 2 1\n-1 -2 1\n1 2 -1\n-2 0 -1\n1 -2 -1\n";
  const auto ply = [&](const std::string& size, const std::string& corners) {
    return "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty float z\n"
           "element tristrips 1\nproperty list int int vertex_indices\nend_header\n" +
           points + size + ' ' + corners + '\n';
  };
  // only triangles as strips, one with a corner twice, in a form that faces are read from at once
  std::string binary = "ply\nformat binary_little_endian 1.0\nelement vertex 6\nproperty double x\nproperty double y\n"
                       "property double z\nelement face 0\nproperty list uchar int vertex_indices\n"
                       "element tristrips 9\nproperty list uchar int vertex_indices\nend_header\n";
  std::istringstream numbers(points);
  for(double x; numbers >> x;)
    tool::append_number(binary, x, tool::Byte_order::LITTLE);
  for(std::size_t i = 0; i < 9; ++i) {
    binary += '\3';
    for(const int corner : i < 8 ? expected[i] : std::array<int, 3>{4, 4, 5})
      tool::append_number(binary, std::int32_t(corner), tool::Byte_order::LITTLE);
  }
  const std::string vtp =
    "<VTKFile type='PolyData'><PolyData><Piece NumberOfPoints='6' NumberOfPolys='1' NumberOfStrips='2'><Points>"
    "<DataArray type='Float32' format='ascii'>" +
    points +
    "</DataArray></Points>"
    "<Polys><DataArray type='Int32' Name='connectivity' format='ascii'>3 5 4</DataArray>"
    "<DataArray type='Int32' Name='offsets' format='ascii'>3</DataArray></Polys>"
    "<Strips><DataArray type='Int32' Name='connectivity' format='ascii'>0 3 1 4 2 5 0 3 0 1 2</DataArray>"
    "<DataArray type='Int32' Name='offsets' format='ascii'>8 11</DataArray></Strips></Piece></PolyData></VTKFile>";
  const std::vector<std::pair<std::string, std::string>> files = {
    {"separated.ply", ply("16", "0 3 1 4 2 5 0 3 -1 0 1 2 -1 3 5 4")},
    {"joined.ply", ply("19", "0 3 1 4 2 5 0 3 3 0 0 1 2 2 3 3 3 5 4")}, // by triangles with a corner twice
    {"binary.ply", binary},
    {"in.vtk", "# vtk DataFile Version 3.0\nbelow is an empty line\n\nASCII\nDATASET POLYDATA\nPOINTS 6 float\n" +
                 points + "TRIANGLE_STRIPS 3 17\n8 0 3 1 4 2 5 0 3\n3 0 1 2\n3 3 5 4\n"},
    {"in.vtp", vtp},
    {"grid.vtk",
     "# vtk DataFile Version 3.0\ncells of several kinds\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 6 float\n" + points +
       "CELLS 5 22\n8 0 3 1 4 2 5 0 3\n2 0 1\n3 0 1 2\n3 3 5 4\n1 5\nCELL_TYPES 5\n6 3 6 7 1\n"},
    {"in.vtu", "<VTKFile type='UnstructuredGrid'><UnstructuredGrid><Piece NumberOfPoints='6' NumberOfCells='4'><Points>"
               "<DataArray type='Float32' format='ascii'>" +
                 points +
                 "</DataArray></Points><Cells>"
                 "<DataArray type='Int32' Name='connectivity' format='ascii'>3 5 4 0 0 3 1 4 2 5 0 3 0 1 2</DataArray>"
                 "<DataArray type='Int32' Name='offsets' format='ascii'>3 4 12 15</DataArray>"
                 "<DataArray type='UInt8' Name='types' format='ascii'>7 1 6 5</DataArray>"
                 "</Cells></Piece></UnstructuredGrid></VTKFile>"}};
  for(const auto& [name, content] : files) {
    CAPTURE(name);
    write_text(scratch / name, content);
    std::vector<std::array<int, 3>> triangles;
    for(std::array<int, 3> t : tool::read_triangles(scratch / name).triangles) {
      std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
      triangles.push_back(t);
    }
    CHECK(std::is_permutation(triangles.begin(), triangles.end(), expected.begin(), expected.end()));
  }
  const auto strip = [&](double scale) {
    std::string content; // joined by triangles with a corner twice
    for(const int corner : {0, 3, 1, 4, 2, 5, 0, 3, 3, 0, 0, 1, 2, 2, 3, 3, 3, 5, 4})
      content += char(corner);
    content += '\0';
    std::istringstream all(points);
    for(float x; all >> x;)
      tool::append_number(content, x, tool::Byte_order::LITTLE);
    const nlohmann::json view = {{"buffer", 0}, {"byteLength", 19}};
    return nlohmann::json(
             {{"asset", {{"version", "2.0"}}},
              {"scenes", {{{"nodes", {0}}}}},
              {"nodes", {{{"mesh", 0}, {"scale", {scale, 1, 1}}}}},
              {"meshes", {{{"primitives", {{{"attributes", {{"POSITION", 1}}}, {"indices", 0}, {"mode", 5}}}}}}},
              {"accessors",
               {{{"bufferView", 0}, {"componentType", 5121}, {"count", 19}, {"type", "SCALAR"}},
                {{"bufferView", 1}, {"componentType", 5126}, {"count", 6}, {"type", "VEC3"}}}},
              {"bufferViews", {view, {{"buffer", 0}, {"byteOffset", 20}, {"byteLength", 72}}}},
              {"buffers", {{{"byteLength", 92}, {"uri", "data:;base64," + tool::to_base64(content)}}}}})
      .dump();
  };
  write_text(scratch / "in.gltf", strip(1));
  write_text(scratch / "mirrored.gltf", strip(-1));
  const tool::Mesh gltf = tool::read_mesh(scratch / "in.gltf").mesh;
  const tool::Mesh mirrored = tool::read_mesh(scratch / "mirrored.gltf").mesh;
  CHECK(gltf.number_of_faces() == 8);
  REQUIRE(mirrored.number_of_faces() == 8);
  for(std::size_t f = 0; f < 8; ++f) {
    const auto [a, b, c] = gltf.triangle(f);
    CHECK((mirrored.triangle(f) == std::array<int, 3>{a, c, b}));
  }
  for(const auto& [corners, word] : {std::pair("3 0 1 6", "strip 0 has the vertex 6"),
                                     {"3 0 1 -2", "strip 0 has the vertex -2"},
                                     {"3 0 0 1", "no faces"}}) {
    write_text(scratch / "broken.ply", ply("", corners));
    CAPTURE(corners);
    check_refused(scratch, scratch / "broken.ply", word);
  }
}

TEST_CASE("formats: arrays of VTK's indices have 32 bits, whatever stands before the faces", "[tool][formats]")
{
  Scratch scratch;
  const std::vector<std::array<int, 3>> faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  std::string bytes = "# vtk DataFile Version 3.0\nindices\nBINARY\nDATASET POLYDATA\nPOINTS 4 float\n";
  for(const float x : {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1})
    tool::append_number(bytes, x, tool::Byte_order::BIG);
  bytes += "\nPOLYGONS 4 16\n";
  for(const auto& face : faces)
    for(const int i : {3, face[0], face[1], face[2]})
      tool::append_number(bytes, std::int32_t(i), tool::Byte_order::BIG);
  bytes += "\nPOINT_DATA 4\nFIELD FieldData 2\nids 1 4 vtkIdType\n";
  for(const int i : {5, 6, 7, 8})
    tool::append_number(bytes, std::int32_t(i), tool::Byte_order::BIG);
  bytes += "\nlong 1 4 vtktypeuint64\n";
  for(const int i : {9, 10, 11, 12})
    tool::append_number(bytes, std::uint64_t(i), tool::Byte_order::BIG);
  write_text(scratch / "in.vtk", bytes + "\n");
  const tool::Soup soup = tool::read_triangles(scratch / "in.vtk");
  CHECK(std::equal(soup.triangles.begin(), soup.triangles.end(), faces.begin(), faces.end()));
  REQUIRE(soup.data.size() == 2);
  CHECK((soup.data[0].values == std::vector<double>{5, 6, 7, 8}));
  CHECK((soup.data[1].values == std::vector<double>{9, 10, 11, 12}));
}

TEST_CASE("formats: dialects of other programs", "[tool][formats]")
{
  Scratch scratch;
  const auto triangles_of = [&](const std::string& name, const std::string& content) {
    write_text(scratch / name, content);
    return tool::read_triangles(scratch / name).triangles;
  };
  const tool::Input_mesh mesh = input_of(bumpy_sphere(1));

  SECTION("columns of OFF in the order of MeshLab, or in another one")
  {
    for(const std::string columns : {"NCST", "CST", "NC", "CN", "STCN", "STNC", "CSTN"})
      CHECK(triangles_of("in", columns + "OFF\n3 1 0\n0 0 0 9 9 9\n1 0 0 9 9 9\n0 1 0 9 9 9\n3 0 1 2\n").size() == 1);
  }
  SECTION("pixels of VTK are listed row by row")
  {
    const auto pixel =
      triangles_of("in.vtk", "# vtk DataFile Version 3.0\npixel\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n"
                             "0 0 0 1 0 0 0 1 0 1 1 0\nCELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n8\n");
    REQUIRE(pixel.size() == 2);
    CHECK((pixel[0] == std::array<int, 3>{0, 1, 3}));
    CHECK((pixel[1] == std::array<int, 3>{0, 3, 2}));
  }
  SECTION("polygons of CIVET, with a colour for all, for each polygon, for each point")
  {
    const auto mni = [&](int colours, const std::string& ends) {
      std::string text = "P 0.3 0.3 0.4 10 1 " + std::to_string(mesh.mesh.number_of_vertices()) + '\n';
      for(int copies = 0; copies < 2; ++copies) // normals have the form of points
        for(const tool::Point& p : mesh.mesh.points())
          text += std::to_string(p[0]) + ' ' + std::to_string(p[1]) + ' ' + std::to_string(p[2]) + '\n';
      const std::size_t faces = mesh.mesh.number_of_faces();
      text += '\n' + std::to_string(faces) + '\n' + std::to_string(colours) + '\n';
      for(std::size_t i = 0; i < (colours == 0 ? 1 : colours == 1 ? faces : mesh.mesh.number_of_vertices()); ++i)
        text += "1 0 0.5 1\n";
      for(std::size_t f = 1; f < faces; ++f)
        text += ' ' + std::to_string(3 * f);
      text += ' ' + ends + '\n';
      for(std::size_t f = 0; f < faces; ++f)
        for(const int corner : mesh.mesh.triangle(f))
          text += ' ' + std::to_string(corner);
      return text;
    };
    const std::string end = std::to_string(3 * mesh.mesh.number_of_faces());
    for(const int colours : {0, 1, 2}) {
      write_text(scratch / "in.obj", mni(colours, end));
      CHECK(have_same_triangles(tool::read_mesh(scratch / "in.obj").mesh, mesh.mesh));
    }
    for(const auto& [text, word] : {std::pair(mni(3, end), "0, 1 or 2"),
                                    {mni(0, end + " x"), "'x' stands where"},
                                    {mni(0, end) + " 7", "more behind"},
                                    {mni(0, "-9223372036854775808"), "'-9223372036854775808' stands where"},
                                    {mni(0, "1"), "fewer than three corners"},
                                    {mni(0, "99999"), "cut short"},
                                    {mni(0, end).substr(0, 800), "cut short"},
                                    {"P 1 1 1 1 1 999999999 1 1 1"s, "'999999999' points"}}) {
      write_text(scratch / "broken.obj", text);
      CAPTURE(word);
      check_refused(scratch, scratch / "broken.obj", word);
    }
    const Process_result run = run_tool({"map", scratch / "in.obj", "-o", scratch / "out.off", "--format", "mni"});
    CHECK(run.exit_code == 2);
  }
  SECTION("OFF BINARY of Geomview and CGAL, with and without colours, and of pmp")
  {
    const auto order_and_colours = {std::pair(tool::Byte_order::BIG, 0),
                                    {tool::Byte_order::BIG, 4},
                                    {tool::Byte_order::LITTLE, -1}}; // -1: not even their number
    for(const auto& [order, colours] : order_and_colours) {
      std::string bytes = "OFF BINARY\n";
      const auto append = [&, order = order](std::size_t number) {
        tool::append_number(bytes, static_cast<std::int32_t>(number), order);
      };
      for(const std::size_t count : {mesh.mesh.number_of_vertices(), mesh.mesh.number_of_faces(), std::size_t(0)})
        append(count);
      for(const tool::Point& p : mesh.mesh.points())
        for(const double x : p)
          tool::append_number(bytes, static_cast<float>(x), order);
      for(std::size_t f = 0; f < mesh.mesh.number_of_faces(); ++f) {
        append(3);
        for(const int corner : mesh.mesh.triangle(f))
          append(static_cast<std::size_t>(corner));
        for(int i = -1; i < colours; ++i)
          i < 0 ? append(static_cast<std::size_t>(colours)) : tool::append_number(bytes, .5F, order);
      }
      write_text(scratch / "in.off", bytes);
      const tool::Mesh copy = tool::read_mesh(scratch / "in.off").mesh;
      CHECK(have_same_triangles(copy, mesh.mesh));
      CHECK(copy.points()[5][1] == static_cast<float>(mesh.mesh.points()[5][1]));
      write_text(scratch / "in.off", bytes.substr(0, bytes.size() - 4));
      check_refused(scratch, scratch / "in.off", "cut short");
      write_text(scratch / "in.off", "C" + bytes);
      check_refused(scratch, scratch / "in.off", "'COFF BINARY'");
    }
  }
  SECTION("GIFTI of before the standard")
  {
    const auto gifti = [](const std::string& encoding, const std::string& endian, const std::string& points,
                          const std::string& triangles, const std::string& order = "GIFTI_IND_ORD_COL_MAJOR") {
      const auto array = [&](const char* intent, const char* type, const std::string& data) {
        return std::string("<DataArray Intent='NIFTI_INTENT_") + intent + "' DataType='NIFTI_TYPE_" + type +
               "' ArrayIndexingOrder='" + order + "' Dimensionality='2' Dim0='4' Dim1='3' Encoding='" + encoding +
               "' Endian='" + endian + "'><Data>" + data + "</Data></DataArray>";
      };
      return "<GIFTI>" + array("POINTSET", "FLOAT32", points) + array("TRIANGLE", "INT32", triangles) + "</GIFTI>";
    };
    const std::vector<float> points = {0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}; // column by column
    const std::vector<std::int32_t> triangles = {0, 0, 1, 2, 2, 1, 2, 0, 1, 3, 3, 3};
    const auto bytes = [](const auto& numbers, tool::Byte_order order) {
      std::string result;
      for(const auto number : numbers)
        tool::append_number(result, number, order);
      return result;
    };
    const auto text = [](const auto& numbers) {
      std::string result;
      for(const auto number : numbers)
        result += std::to_string(number) + ' ';
      return result;
    };
    const auto base64 = [&](const auto& numbers, tool::Byte_order order) {
      return tool::to_base64(bytes(numbers, order));
    };
    const auto big = tool::Byte_order::BIG, little = tool::Byte_order::LITTLE;
    for(const std::string& file :
        {gifti("GIFTI_ENCODING_ASCII", "GIFTI_ENDIAN_LITTLE", text(points), text(triangles)),
         gifti("GIFTI_ENCODING_B64BIN", "GIFTI_ENDIAN_LITTLE", base64(points, little), base64(triangles, little)),
         gifti("GIFTI_ENCODING_B64BIN", "GIFTI_ENDIAN_BIG", base64(points, big), base64(triangles, big))}) {
      write_text(scratch / "old.gii", file);
      const tool::Soup soup = tool::read_triangles(scratch / "old.gii");
      REQUIRE(soup.triangles.size() == 4);
      CHECK((soup.triangles[1] == std::array<int, 3>{0, 1, 3}));
      CHECK((soup.points[1] == std::array<double, 3>{1, 0, 0}));
      CHECK((soup.points[3] == std::array<double, 3>{0, 0, 1}));
    }
    write_text(scratch / "old.gii", gifti("GIFTI_ENCODING_EXTBIN", "GIFTI_ENDIAN_BIG", "", ""));
    check_refused(scratch, scratch / "old.gii", "another file");
    write_text(scratch / "old.gii", gifti("ASCII", "LittleEndian", text(points), text(triangles), "Columns"));
    check_refused(scratch, scratch / "old.gii", "'Columns'");
  }
  SECTION("OBJ files of Viewpoint DataLabs have comments behind a dollar sign")
  {
    for(const char* name : {"in.obj", "in.txt"})
      CHECK(triangles_of(name, "# cow\n$ contributed\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").size() == 1);
    write_text(scratch / "continued.obj", "\\\n\n");
    check_refused(scratch, scratch / "continued.obj", "begins with ''");
  }
}

TEST_CASE("formats: polygons are cut along diagonals that lie in them", "[tool][formats]")
{
  Random random(7);
  const auto area = [](const std::vector<std::array<double, 3>>& points, const std::array<int, 3>& triangle) {
    const auto at = [&](int k) {
      const auto& p = points[static_cast<std::size_t>(triangle[static_cast<std::size_t>(k)])];
      return Point(p[0], p[1], p[2]);
    };
    return CGAL::cross_product(at(1) - at(0), at(2) - at(0)) / 2;
  };
  const auto check = [&](const std::vector<std::array<double, 3>>& points) {
    tool::Soup soup;
    soup.points = points;
    std::vector<int> corners(points.size());
    std::iota(corners.begin(), corners.end(), 0);
    soup.add_face({0, 1, 2});
    soup.add_face(corners);
    soup.add_face({2, 1, 0});
    const auto fan = soup.triangles;
    tool::cut_polygons(soup);
    REQUIRE(soup.triangles.size() == fan.size());
    CHECK(soup.triangles.front() == fan.front());
    CHECK(soup.triangles.back() == fan.back());
    CGAL::Vector_3<Kernel> sum(0, 0, 0);
    std::map<std::pair<int, int>, int> halfedges;
    double areas = 0;
    for(std::size_t f = 1; f + 1 < soup.triangles.size(); ++f) {
      const CGAL::Vector_3<Kernel> normal = area(points, soup.triangles[f]);
      sum = sum + normal;
      areas += std::sqrt(normal.squared_length());
      for(std::size_t k = 0; k < 3; ++k)
        ++halfedges[{soup.triangles[f][k], soup.triangles[f][(k + 1) % 3]}];
    }
    CHECK(areas == Approx(std::sqrt(sum.squared_length())).epsilon(1e-9)); // nothing is folded back
    for(const auto& [ends, times] : halfedges) {
      CHECK(times == 1);
      const bool is_side = ends.second == (ends.first + 1) % static_cast<int>(points.size());
      CHECK(halfedges.count({ends.second, ends.first}) == (is_side ? 0 : 1));
    }
    return std::equal(fan.begin(), fan.end(), soup.triangles.begin());
  };
  for(int i = 0; i < 200; ++i) { // stars in planes of all directions, every third one with corners on a straight line
    const int n = 4 + i % 40;
    const Point u(random.number(), random.number(), random.number()),
      v(random.number(), random.number(), random.number());
    std::vector<std::array<double, 3>> points;
    for(int k = 0; k < n; ++k) {
      const double angle = 2 * CGAL_PI * k / n, r = 1 + .9 * random.number(), x = r * std::cos(angle),
                   y = r * std::sin(angle);
      points.push_back({x * u.x() + y * v.x(), x * u.y() + y * v.y(), x * u.z() + y * v.z()});
    }
    if(i % 3 == 0) {
      std::vector<std::array<double, 3>> finer;
      for(std::size_t k = 0; k < points.size(); ++k) {
        finer.push_back(points[k]);
        finer.push_back({});
        for(std::size_t axis = 0; axis < 3; ++axis)
          finer.back()[axis] = (points[k][axis] + points[(k + 1) % points.size()][axis]) / 2;
      }
      points = std::move(finer);
    }
    check(points);
  }
  CHECK(check({{{0, 0, 0}}, {{1, 0, 0}}, {{1, 1, 0}}, {{0, 1, 0}}})); // a convex one keeps its fan
  CHECK_FALSE(check({{{0, 0, 0}}, {{.1, .1, 0}}, {{1, 0, 0}}, {{0, 1, 0}}}));
  check({{{0, 0, 0}},
         {{3, 0, 0}},
         {{3, 3, 0}},
         {{0, 3, 0}},
         {{0, 0, 0}}, // cut open to a hole
         {{1, 1, 0}},
         {{1, 2, 0}},
         {{2, 2, 0}},
         {{2, 1, 0}},
         {{1, 1, 0}}});

  // Corners on straight lines, which the neighbours have: a cube of polygons, turned, and rounded to floats.
  constexpr int half = 2; // as many edges are half a side
  for(const double angle : {0., .3, .7, 1.1}) {
    tool::Soup cube;
    std::map<std::array<int, 3>, int> number;
    for(const auto& [axis, side] : {std::pair(0, 1), {0, -1}, {1, 1}, {1, -1}, {2, 1}, {2, -1}}) {
      std::vector<int> corners;
      std::array<int, 2> uv = {0, -half}, step = {1, 0};
      for(int k = 0; k < 8 * half; ++k) { // counterclockwise
        std::array<int, 3> p = {};
        p[static_cast<std::size_t>(axis)] = side * half;
        p[static_cast<std::size_t>((axis + 1) % 3)] = side * uv[0];
        p[static_cast<std::size_t>((axis + 2) % 3)] = uv[1];
        const auto [place, is_new] = number.emplace(p, static_cast<int>(number.size()));
        if(is_new) {
          const double x = p[0] * std::cos(angle) - p[1] * std::sin(angle);
          const double y = p[0] * std::sin(angle) + p[1] * std::cos(angle), c = std::cos(2 * angle);
          const double s = std::sin(2 * angle);
          cube.points.push_back(
            {static_cast<float>(x), static_cast<float>(y * c - p[2] * s), static_cast<float>(y * s + p[2] * c)});
        }
        corners.push_back(place->second);
        if(std::abs(uv[0]) == half && std::abs(uv[1]) == half)
          step = {-step[1], step[0]};
        uv = {uv[0] + step[0], uv[1] + step[1]};
      }
      cube.add_face(corners);
    }
    tool::cut_polygons(cube);
    REQUIRE(cube.points.size() == 24 * half - 4);
    CHECK(tool::Mesh(cube.points, cube.triangles).number_of_faces() == 2 * cube.points.size() - 4); // no face twice
    for(const std::array<int, 3>& triangle : cube.triangles)
      CHECK(std::sqrt(area(cube.points, triangle).squared_length()) > .4); // none is flat
  }
  std::vector<std::array<double, 3>> wild; // crosses itself: as many triangles all the same, and soon
  for(int i = 0; i < 10000; ++i)
    wild.push_back({random.number(), random.number(), 0});
  tool::Soup soup;
  soup.points = wild;
  std::vector<int> corners(wild.size());
  std::iota(corners.begin(), corners.end(), 0);
  soup.add_face(corners);
  const auto start = std::chrono::steady_clock::now();
  tool::cut_polygons(soup);
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(10)); // in cubic time: 53
  CHECK(soup.triangles.size() == wild.size() - 2);

  Scratch scratch;
  write_text(scratch / "in.off", "OFF\n4 1 0\n0 0 0\n1 1 0\n10 0 0\n0 10 0\n4 0 1 2 3\n");
  CHECK((tool::read_triangles(scratch / "in.off").triangles[0] != std::array<int, 3>{0, 1, 2}));
}

TEST_CASE("formats: points that are not numbers are not compared with each other", "[tool][formats]")
{
  Scratch scratch;
  constexpr std::uint32_t triangles = 20000;
  std::string bytes(80, ' ');
  tool::append_number(bytes, triangles, tool::Byte_order::LITTLE);
  for(std::uint32_t i = 0; i < 12 * triangles; ++i) {
    tool::append_number(bytes, std::numeric_limits<float>::quiet_NaN(), tool::Byte_order::LITTLE);
    if(i % 12 == 11)
      bytes += "  ";
  }
  write_text(scratch / "in.stl", bytes);
  const auto start = std::chrono::steady_clock::now();
  CHECK(tool::read_triangles(scratch / "in.stl", tool::Coordinates::ANY).points.size() == 3 * triangles);
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(3)); // else 14
}

TEST_CASE("formats: broken files are refused before they cost memory", "[tool][formats]")
{
  Scratch scratch;
  const tool::Input_mesh mesh = input_of(bumpy_sphere(2));
  const auto check = [&](const std::string& name, const std::string& content, const std::string& word) {
    write_text(scratch / name, content);
    CAPTURE(name, word);
    check_refused(scratch, scratch / name, word);
    CHECK(run_tool({"map", scratch / name, "-o", scratch / "out.off"}).peak_memory < 300 * 1000 * 1000);
    fs::remove(scratch / name);
  };
  const auto content = [&](const std::string& name, tool::Mesh_format format, const tool::Input_mesh& input) {
    write(scratch / name, {format}, input);
    std::string bytes = text_of(scratch / name);
    fs::remove(scratch / name);
    return bytes;
  };
  const auto changed = [](std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    REQUIRE(at != std::string::npos);
    return text.replace(at, from.size(), to);
  };

  SECTION("compressed files")
  {
    for(const std::string extension : {".gz", ".xz", ".zst", ".bz2"}) {
      const std::string bytes = content("in.off" + extension, tool::Mesh_format::OFF, mesh);
      check("in.off" + extension, bytes.substr(0, bytes.size() / 2), "cut short");
      // blocks of zstd: what was unfolded before the end could be taken for all, as .obj announces nothing
      const std::string large = content("in.obj" + extension, tool::Mesh_format::OBJ, input_of(icosphere(6)));
      for(int k = 1; k < 8; ++k)
        check("in.obj" + extension, large.substr(0, large.size() * k / 8), "cut short");
      check("noise" + extension, bytes.substr(0, 6) + std::string(300, 'x'), "");
      // 200 million zeros: gzip folds them to their thousandth part, and the others to less
      const std::string bomb = scratch / ("bomb.ply" + extension);
      {
        tool::Atomic_files out;
        std::ostream& bytes_of_bomb = out.open(bomb);
        const std::string zeros(1000000, '\0');
        for(int i = 0; i < 200; ++i)
          bytes_of_bomb << zeros;
        out.commit();
      }
      check_refused(scratch, bomb, "");
      fs::remove(bomb);
    }
  }
  SECTION("FreeSurfer")
  {
    const std::string good = content("lh.white", tool::Mesh_format::FREESURFER, mesh);
    const std::size_t counts = good.find("\n\n") + 2;
    const auto with_number = [&](std::size_t at, auto number) {
      std::string bytes;
      tool::append_number(bytes, number, tool::Byte_order::BIG);
      return std::string(good).replace(at, 4, bytes);
    };
    check("lh.white", good.substr(0, good.size() - 10), "cut short");
    check("lh.white", good.substr(0, 20), "cut short");
    check("lh.white", with_number(counts, std::int32_t(700000000)), "cut short");
    check("lh.white", with_number(counts, std::int32_t(-1)), "damaged");
    check("lh.white", with_number(counts + 8, std::numeric_limits<float>::quiet_NaN()), "finite");
    check("lh.white", with_number(good.size() - 4, std::int32_t(100000)), "100000");
    check("lh.white", with_number(counts + 4, std::int32_t(0)), "no faces");
    check("lh.quads", changed(good, "\xff\xff\xfe", "\xff\xff\xfd"), "mris_convert");
  }
  SECTION("GIFTI")
  {
    const std::string good = content("in.gii", tool::Mesh_format::GIFTI, mesh);
    check("in.gii", good.substr(0, good.size() - 30), "line ");
    check("in.gii", changed(good, "Dim0=\"", "Dim0=\"9999"), "cut short");
    check("in.gii", changed(good, "Dim0=\"", "Dim0=\"-"), "Dim0");
    check("in.gii", changed(good, "Dim1=\"3", "Dim1=\"4"), "rows of three");
    check("in.gii", changed(good, "NIFTI_INTENT_POINTSET", "NIFTI_INTENT_SHAPE"), ".surf.gii");
    check("in.gii", changed(good, "NIFTI_INTENT_TRIANGLE", "NIFTI_INTENT_POINTSET"), "several");
    check("in.gii", changed(good, "GZipBase64Binary", "ExternalFileBinary"), "another file");
    check("in.gii", changed(good, "GZipBase64Binary", "Base64Binary"), "announces");
    check("in.gii", changed(good, "<Data>", "<Data>####"), "Base64");
    const auto array = [](const std::string& intent, const std::string& type, const std::string& numbers) {
      return "<DataArray Intent='NIFTI_INTENT_" + intent + "' DataType='NIFTI_TYPE_" + type +
             "' ArrayIndexingOrder='RowMajorOrder' Dimensionality='2' Dim0='4' Dim1='3' Encoding='ASCII'><Data>" +
             numbers + "</Data></DataArray>";
    };
    const auto text = [&](const std::string& more) {
      return "<GIFTI>" + array("POINTSET", "FLOAT32", "0 0 0 1 0 0 0 1 0 0 0 1" + more) +
             array("TRIANGLE", "INT32", "0 2 1 0 1 3 1 2 3 2 0 3") + "</GIFTI>";
    };
    write_text(scratch / "text.gii", text("\n"));
    CHECK(refusal(scratch / "text.gii") == "not refused");
    check("in.gii", text(" 7"), "more numbers than");
    check("in.gii", changed(good, "NIFTI_TYPE_FLOAT32", "NIFTI_TYPE_COMPLEX64"), "type");
    check("in.gii",
          "<?xml version=\"1.0\"?>\n<!DOCTYPE GIFTI [<!ENTITY a \"aaaaaaaaaa\"><!ENTITY b \"&a;&a;&a;\">]>\n"
          "<GIFTI>&b;</GIFTI>\n",
          "no points");
  }
  SECTION("GLB")
  {
    const std::string good = content("in.glb", tool::Mesh_format::GLB, mesh);
    check("in.glb", good.substr(0, good.size() - 10), "cut short");
    check("in.glb", good.substr(0, 15), "cut short");
    check("in.glb", changed(good, std::string("\2\0\0\0", 4), std::string("\1\0\0\0", 4)), "version");
    check("in.glb", changed(good, "POSITION", "POSITIOM"), "without positions");
    check("in.gltf", R"({"asset": {"version": "1.0"}, "meshes": {"a": {}}})", "version 1");
  }
}

TEST_CASE("formats: text has the fewest digits from which the same number is read", "[tool][formats]")
{
  Scratch scratch;
  tool::Input_mesh mesh = input_of(icosphere(1));
  std::vector<tool::Point> points = mesh.mesh.points();
  points[0] = {0.1, 1e-300, -0.30000000000000004};
  points[1] = {1e22, 5e-324, 123456789};
  for(const tool::Output_format& format :
      {tool::Output_format{tool::Mesh_format::OFF}, {tool::Mesh_format::OBJ}, {tool::Mesh_format::PLY, true}}) {
    std::ostringstream out;
    tool::write_mesh(out, format, mesh.mesh, points, tool::Surface::SHAPE);
    CHECK(contains(out.str(), "0.1 1e-300 -0.30000000000000004\n"));
    CHECK(contains(out.str(), "1e+22 5e-324 123456789\n"));
  }
}

TEST_CASE("formats: through pipes, data goes to the standard output and messages do not", "[tool][formats]")
{
  Scratch scratch;
  const std::string input = write_off(scratch / "in.off", bumpy_sphere(2));
  REQUIRE(run_tool({"map", input, "-o", scratch / "out.off"}).exit_code == 0);
  const std::string line = "cat \"$1\" | \"$0\" map - -o - --format off";
  const Process_result run = run_process({"/bin/sh", "-c", line, TOOL, input});
  CAPTURE(run.err);
  CHECK(run.exit_code == 0);
  CHECK((run.out == text_of(scratch / "out.off")));
  CHECK(contains(run.err, "standard input: "));
  CHECK(contains(run.err, "written: standard output"));
  CHECK(run_process({"/bin/sh", "-c", line + " --quiet", TOOL, input}).err.empty());

  const Process_result empty = run_tool({"map", "-", "-o", scratch / "x.off"});
  CHECK(empty.exit_code == 1);
  CHECK(contains(empty.err, "standard input: is empty"));
  CHECK(run_tool({"map", input, "-o", "-"}).exit_code == 2);
  const Process_result full =
    run_process({"/bin/sh", "-c", "\"$0\" map \"$1\" -o - --format ply >/dev/full", TOOL, input});
  CHECK(full.exit_code == 1);
  CHECK(contains(full.err, "standard output: could not be written completely"));

  const std::string large = write_off(scratch / "large.off", bumpy_sphere(5)); // more than a pipe holds
  run_process(
    {"/bin/sh", "-c", "TMPDIR=\"$2\" \"$0\" map -q \"$1\" -o - --format ply | true", TOOL, large, scratch.folder()});
  CHECK(scratch.number_of_files() == 3); // no temporary file stays behind
}

TEST_CASE("quiet and verbose", "[tool]")
{
  Scratch scratch;
  const std::string input = write_off(scratch / "in.off", capsule(20, 12));
  const std::vector<std::string> map = {"map",      input,       "-o",       scratch / "out.off",
                                        "--method", "automatic", "--report", scratch / "report.json"};
  const auto run = [&](const std::string& flag) {
    std::vector<std::string> arguments = map;
    arguments.push_back(flag);
    return run_tool(arguments);
  };
  const Process_result quiet = run("--quiet"), verbose = run("-v");
  CHECK(quiet.exit_code == 0);
  CHECK(quiet.out.empty());
  CHECK(quiet.err.empty());
  CHECK(contains(verbose.out, "\ntried balanced for "));
  CHECK(contains(verbose.out, "\ntried isometric for "));

  const auto attempts = nlohmann::json::parse(text_of(scratch / "report.json")).at("attempts");
  REQUIRE(attempts.size() >= 2);
  CHECK(attempts.front().at("method") == "balanced");
  CHECK(attempts.front().at("error_code") == "NOT_BIJECTIVE");
  CHECK(attempts.front().at("seconds") > 0);
  CHECK(attempts.back().at("error_code") == "OK");
}
